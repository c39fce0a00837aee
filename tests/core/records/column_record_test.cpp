// SPDX-License-Identifier: MIT
#include "record_texts.hpp"

BOOST_AUTO_TEST_SUITE(column_record_test)

namespace {

using namespace stillpoint::test;

const std::string uneven = "0 0.5\n0.1 -1\n0.25 0.25\n";

const std::vector<Good> columns{
    right("time_and_value", uneven, plain, 0, {0, 0.1, 0.25}),
    right("tabs", "0\t0.5\n0.1\t-1\n0.25\t0.25\n", plain, 0, {0, 0.1, 0.25}),
    right("commas", "0,0.5\n0.1,-1\n0.25,0.25\n", plain, 0, {0, 0.1, 0.25}),
    right("commas_and_blanks", " 0 , 0.5\n0.1,\t-1 \n\t0.25 ,0.25\n", plain, 0, {0, 0.1, 0.25}),
    right("comments_and_blank_lines",
          "# a\n\n0 0.5 # b\n  # c, NPTS\n0.1 -1#d\n \t \n0.25 0.25\n\n", plain, 0, {0, 0.1, 0.25}),
    right("crlf", with_crlf("# a\n\n" + uneven), plain, 0, {0, 0.1, 0.25}),
    right("no_final_newline", "0 0.5\n0.1 -1\n0.25 0.25", plain, 0, {0, 0.1, 0.25}),
    right("byte_order_mark", "\xEF\xBB\xBF" + uneven, plain, 0, {0, 0.1, 0.25}),
    right("fortran_numbers", "0.D0 .5E+00\n1.0D-1 -1.\n.25E0 2.5D-01\n", plain, 0, {0, 0.1, 0.25}),
    right("end_of_file_of_dos", with_crlf(uneven) + "\x1A", plain, 0, {0, 0.1, 0.25}),
    right("times_from_above_zero", "1 0.5\n2 -1\n4 0.25\n", plain, 0, {1, 2, 4}),
    right("times_one_ulp_apart", "1 0.5\n1.0000000000000002 -1\n3 0.25\n", plain, 0,
          {1, 1 + 0x1p-52, 3}),
    right("one_row", "0 0.5\n", {0.5}, 0, {0}),
    right("uniform", "0 0.5\n0.02 -1\n0.04 0.25\n", plain, 0.02),
    right("uniform_in_other_forms", "0.000 0.5\n2e-2 -1\n4.D-2 0.25\n", plain, 0.02),
    right("uniform_from_elsewhere", "0.02 0.5\n0.04 -1\n0.06 0.25\n", plain, 0, {0.02, 0.04, 0.06}),
    right("thirds_rounded_to_four_digits", "0 0.5\n0.3333 -1\n0.6667 0.25\n", plain, 0,
          {0, 0.3333, 0.6667}),
    right("value_alone", "0.5\n-1\n0.25\n", plain, 0.02, {}, with_step(0.02)),
    right("value_alone_with_comments", "# a\n0.5\n\n-1 # b\n0.25", plain, 0.02, {},
          with_step(0.02)),
    right("one_value", "0.5", {0.5}, 0.02, {}, with_step(0.02)),
    right("m_s_2", "0 1\n0.1 9.80665\n0.3 -9.80665\n", {1 / 9.80665, 1, -1}, 0, {0, 0.1, 0.3},
          with_units(RecordUnits::m_per_s2)),
    right("cm_s_2", "0 1\n0.1 980.665\n0.3 -980.665\n", {1 / 980.665, 1, -1}, 0, {0, 0.1, 0.3},
          with_units(RecordUnits::cm_per_s2)),
    right("cm_s_2_on_the_moon", "0 0\n0.1 162\n0.3 -81\n", {0, 1, -0.5}, 0, {0, 0.1, 0.3},
          with_units(RecordUnits::cm_per_s2, 1, 1.62)),
    right("units_and_scale", "0 0\n0.1 1\n0.3 -2\n", {0, 0.3, -0.6}, 0, {0, 0.1, 0.3},
          with_units(RecordUnits::m_per_s2, 3, 10)),
    right("heading", "time,accel\n0,0.5\n0.1,-1\n0.25,0.25\n", plain, 0, {0, 0.1, 0.25}),
    right("heading_with_units", "# a\n\nTime (s) \"Acc\" (g)\n" + uneven, plain, 0, {0, 0.1, 0.25}),
    right("heading_above_values", "accel\n0.5\n-1\n0.25\n", plain, 0.02, {}, with_step(0.02)),
    right("quotes", "\"t\",\"a\"\n\"0\",\"0.5\"\n\"0.1\", \"-1\"\n\"0.25\",0.25\n", plain, 0,
          {0, 0.1, 0.25}),
    right("line_ends_of_old_macs", "# a\r\r0 0.5\r0.1 -1\r0.25 0.25\r", plain, 0, {0, 0.1, 0.25}),
    right("cr_cr_lf", "0 0.5\r\r\n\r\r\n0.1 -1\r\r\n0.25 0.25\r\r\n", plain, 0, {0, 0.1, 0.25}),
    right("nul_in_a_comment", with_nul("# a") + "b\n" + uneven, plain, 0, {0, 0.1, 0.25}),
    right("times_from_below_zero", "-0.5 0.5\n-0.4 -1\n-0.25 0.25\n", plain, 0, {0, 0.1, 0.25}),
    right("uniform_from_below_zero", "-0.02 0.5\n0 -1\n0.02 0.25\n", plain, 0.02),
    right("count_and_step", "3 0.02\n0.5\n-1\n0.25\n", plain, 0.02),
    right("count_and_step_above_lines", "# a\n3, 0.02\n0.5 -1\n0.25\n", plain, 0.02),
    right("count_and_step_or_a_time", "3 0.5\n4 -1\n6 0.25\n", plain, 0, {3, 4, 6}),
    right("values_in_lines", "0.5 -1\n0.25\n", plain, 0.02, {}, with_step(0.02)),
    right("values_in_a_line", "0.5, -1, 0.25\n", plain, 0.02, {}, with_step(0.02)),
    right("first_of_two", "0 0.5 7\n0.1 -1 7\n0.25 0.25 7\n", plain, 0, {0, 0.1, 0.25},
          {.channel = 1}),
    right("second_of_two", "t,x,y\n0,7,0.5\n0.1,7,-1\n0.25,7,0.25\n", plain, 0, {0, 0.1, 0.25},
          {.channel = 2}),
    right("second_of_two_without_times", "7 0.5\n7 -1\n7 0.25\n", plain, 0.02, {},
          {.step = 0.02, .channel = 2}),
    right("values_that_are_large", "0 1e6\n0.1 -1e6\n0.3 0\n", {1e6, -1e6, 0}, 0, {0, 0.1, 0.3}),
};

const std::vector<Bad> wrong_columns{
    wrong("empty", "", ": is empty"),
    wrong("byte_order_mark_alone", "\xEF\xBB\xBF", ": is empty"),
    wrong("blank", "\n \n", "line 2:...the file has no values"),
    wrong("comments_alone", "# a\n# b\n", "line 2:...the file has no values"),
    wrong("two_headings", "time,acc\ns,g\n0,1\n", "line 2, column 1:...\"s\" is not a number"),
    wrong("heading_alone", "time,acc\n", "line 1: the file has no values"),
    wrong("text_for_a_value", "0 1\n0.1 x\n", "line 2, column 5:...\"x\" is not a number"),
    wrong("text_for_a_time", "0 1\n# c\nx 1\n", "line 3, column 1:...\"x\" is not a number"),
    wrong("semicolons", "0;1\n", "line 1, column 1:...\"0;1\" is not a number...no semicolon"),
    wrong("decimal_commas", "0,01 0,02\n", "line 1: 4 columns...write a decimal comma as a point"),
    wrong("decimal_commas_alone", "0,01\n0,02\n",
          "line 2: time 0: must be more than...write a decimal comma as a point"),
    wrong("decimal_commas_and_semicolons", "0;0,1\n",
          "no semicolon; write a decimal comma as a point"),
    wrong("nan", "0 1\n0.1 nan\n", "line 2, column 5:...\"nan\" is not a finite number"),
    wrong("value_subnormal", "0 1\n0.1 2.2e-308\n",
          "line 2, column 5:...\"2.2e-308\" is out of range"),
    wrong("value_subnormal_once_scaled", "0 1\n0.1 3e-308\n",
          "line 2, column 5:...\"3e-308\" is out of range", scaled(0.5)),
    wrong("time_that_goes_back_below_zero", "-0.1 1\n-0.2 1\n",
          "line 2: time -0.2...more than the previous time, -0.1"),
    wrong("time_beyond_what_a_motion_follows_from_below_zero", "-0.9e150 1\n0.9e150 1\n",
          "line 2: time 9e+149 s...at most 1e+150"),
    wrong("time_subnormal", "2e-308 1\n1 1\n", "line 1, column 1:...\"2e-308\" is out of range"),
    wrong("time_beyond_what_a_motion_follows", "0 1\n1.1e150 1\n",
          "line 2:...time 1.1e+150 s...at most 1e+150"),
    // p times the step, and the step itself, must be at least 1e-150.
    wrong("times_too_near", "0 1\n0.9e-150 1\n", "line 2:...too close to the previous time, 0"),
    wrong("times_too_near_for_a_slow_oscillator", "0 1\n0.9e-140 1\n",
          "line 2:...too close to the previous time, 0", with_p(1e-10)),
    wrong("times_too_near_for_a_fast_oscillator", "0 1\n0.9e-150 1\n",
          "line 2:...too close to the previous time, 0", with_p(1e10)),
    wrong("value_out_of_range_once_scaled", "0 1\n0.1 -1e300\n",
          "line 2, column 5:...\"-1e300\" is out of range", scaled(1e9)),
    wrong("value_beyond_what_a_motion_follows", "0 1\n0.1 1e150\n0.2 1.1e150\n",
          "line 3, column 5:...\"1.1e150\" is out of range...to 1e+150"),
    wrong("value_beyond_what_a_fast_motion_follows", "0 1\n0.1 1.1e150\n",
          "line 2, column 5:...\"1.1e150\" is out of range...to 1e+150", with_p(1e10)),
    wrong("three_columns", "0 1 2\n",
          "line 1: 3 columns, the first of times...choose one by its number, record.txt#1 to #2"),
    wrong("five_columns", "0 1 2 3 4\n0 2 3 4 5\n",
          "line 1: 5 columns...without times need record-step...#1 to #4"),
    wrong("columns_with_times_and_a_step", "0 1 2\n0.1 3 4\n",
          "line 1: the file gives a time with each value, so record-step = 0.1", with_step(0.1)),
    wrong("a_third_component", "0 1 2\n0.1 3 4\n",
          "line 1: there is no channel 3: the last is number 2", {.channel = 3}),
    wrong("a_second_component", "0 1\n0.1 3\n", "line 1: there is no channel 2", {.channel = 2}),
    wrong("a_second_channel_of_values", "1\n3\n", "line 1: there is no channel 2",
          {.step = 0.1, .channel = 2}),
    wrong("line_that_is_short_before_the_end", "3 2 1\n1 2\n1 2 3\n",
          "line 3: 3 columns, but 3 on line 1", with_step(0.1)),
    wrong("line_that_is_longer", "3 2 1\n1 2 3 4\n", "line 2: 4 columns, but 3 on line 1",
          with_step(0.1)),
    wrong("fewer_than_the_count", "3 0.02\n0.5\n-1\n", "line 3: 2 values follow, but 3 on line 1"),
    wrong("more_than_the_count", "2 0.02\n0.5\n-1\n1\n",
          "line 4: 3 values follow, but 2 on line 1"),
    wrong("count_and_step_beside_a_step", "2 0.02\n0.5\n-1\n",
          "line 1: the file gives the step, so record-step = 0.1", with_step(0.1)),
    wrong("decimal_commas_in_lines", "0,5 1,5\n0,1 0,2\n",
          "line 1: 4 columns...write a decimal comma as a point", with_step(0.1)),
    wrong("decimal_commas_with_a_step", "0,5\n0,1\n",
          "line 1: 2 columns...write a decimal comma as a point", with_step(0.1)),
    wrong("decimal_commas_in_quotes", "\"0,5\"\n\"0,1\"\n",
          "line 1: 2 columns...write a decimal comma as a point", with_step(0.1)),
    wrong("a_column_too_many", "0 1\n0.1 2\n0.2 3 4\n", "line 3:...3 columns"),
    wrong("a_column_too_few", "# a\n0 1\n0.1\n", "line 3:...1 column, but 2 on line 2"),
    wrong("a_second_column", "1\n2\n3 4\n", "line 3:...2 columns, but 1 on line 1", with_step(0.1)),
    wrong("a_column_empty", "0,,1\n", "line 1:...column is empty"),
    wrong("a_column_of_a_blank", "0, ,1\n", "line 1:...column is empty"),
    wrong("a_column_empty_in_front", "0,1\n ,1\n", "line 2:...column is empty"),
    wrong("a_column_empty_behind", "0,1\n1,\n", "line 2:...column is empty"),
    wrong("comma_alone", ",\n", "line 1:...column is empty"),
    wrong("time_that_stands", "0 1\n0.1 1\n0.1 2\n",
          "line 3:...time 0.1...more than the previous time, 0.1"),
    wrong("time_that_goes_back", "0 1\n\n0.2 1\n0.1 2\n",
          "line 4:...time 0.1...more than the previous time, 0.2"),
    wrong("step_given_with_times", "# a\n" + uneven, "line 2:...record-step = 0.1", with_step(0.1)),
    wrong("nul", with_nul("0 1\n0.1 2\n"), "line 3: 1 column, but 2 on line 1"),
    wrong("utf_16",
          std::string("\xFF\xFE"
                      "0\0\n\0",
                      6),
          ": is UTF-16 text: save it as UTF-8"),
    wrong("control_byte", "0 1\n0.1 \x07\n", "line 2:...0x07...not text"),
    wrong("bytes_beyond_ascii", "t\n\xC3\x28\xFF\n", "line 2, column 1:...\"?(?\" is not a number"),
    wrong("a_long_word", "t\n" + std::string(5000, 'x'),
          "line 2, column 1:..." + std::string(60, 'x') + "...\" is not"),
};

}  // namespace

BOOST_TEST_DECORATOR(*boost::unit_test::tolerance(4 * std::numeric_limits<double>::epsilon()))
BOOST_DATA_TEST_CASE(columns_are_read, data::make(columns), good) {
  check_read("record.txt", good);
}

BOOST_DATA_TEST_CASE(columns_are_refused, data::make(wrong_columns), bad) {
  check_refused("record.txt", bad);
}

BOOST_AUTO_TEST_CASE(description_of_columns_is_the_first_comment) {
  BOOST_TEST(file_of("a.txt", "#\n0 1 ## a pulse \r\n# two\n").description == "a pulse");
  BOOST_TEST(file_of("a.txt", "0 1\n").description.empty());
  BOOST_TEST(file_of("a.txt", "t, a\n0 1\n").description == "t, a");
  BOOST_TEST(file_of("a.txt", "# b\n-2 1\n-1 1\n").description ==
             "b; the times are counted from the first, -2");
}

BOOST_AUTO_TEST_CASE(values_alone_need_a_step) {
  check_parts(refusal_of<InputError>([] { return file_of("a.txt", "# a\n1\n2\n"); }),
              "record-step is missing...record a.txt...line 2");
}

// Where the rows are not what they seem, the reader says so.
BOOST_AUTO_TEST_CASE(doubts_of_columns) {
  const auto doubt = [](const std::string& text, const RecordOptions& options = {}) {
    return file_of("a.txt", text, options).doubt;
  };
  for (const char* const units : {"m/s2", "m/s/s", "(M/SEC^2)", "m/s**2."}) {
    check_says(doubt("# acceleration in " + std::string(units) + "\n" + uneven),
               {"it names the units m/s2, but its values are read in g", "--record-units m/s2?"});
  }
  check_says(doubt("t,acc (gal)\n" + uneven), {"the units cm/s2"});
  BOOST_TEST(doubt("# in g\n" + uneven) == "");
  BOOST_TEST(doubt("# m/s2, divided by 9.81: in g\n" + uneven) == "");
  BOOST_TEST(doubt("# in m/s2\n" + uneven, with_units(RecordUnits::m_per_s2)) == "");
  BOOST_TEST(doubt("# in m/s2\n" + uneven, with_units(RecordUnits::g)) == "");
  // Of a slow wave neighbours are alike, and in a table of two waves the numbers of a column.
  std::string sequence;
  std::string table;
  for (int i = 0; i < 400; ++i) {
    const std::string value = in_full(std::sin(0.05 * i));
    sequence += value + (i % 4 == 3 ? "\n" : " ");
    table += value + " " + in_full(2 + std::cos(0.05 * i)) + "\n";
  }
  BOOST_TEST(doubt(sequence, with_step(0.01)) == "");
  check_says(doubt(table, with_step(0.01)),
             {"its 2 values a line are read one after the other", "choose one, #1 to #2"});
}

// The same numbers, with times from -2 s on.
BOOST_AUTO_TEST_CASE(decimal_times_from_below_zero_are_a_step) {
  std::string text;
  for (int i = -200; i < 4000; ++i) {
    text += in_full(i / 100.0) + " 1\n";  // the double nearest to the decimal
  }
  const Record record = record_of("a.txt", text);
  BOOST_TEST(record.times.empty());
  BOOST_TEST(std::abs(record.step - 0.01) <= 0x1p-52);
}

// ---- a step in place of times

namespace {

/// The step that is read from these times.
double step_of(const Samples& times) {
  std::string text;
  for (const double time : times) {
    text += in_full(time) + " 1\n";
  }
  const Record record = record_of("times.txt", text);
  BOOST_TEST((record.step == 0 ? record.times == times : record.times.empty()));
  return record.step;
}

}  // namespace

BOOST_AUTO_TEST_CASE(decimal_times_are_a_step) {
  for (const double rate : {50.0, 100.0, 128.0, 200.0, 1000.0, 1024.0}) {
    Samples times;
    for (int i = 0; i < 20000; ++i) {
      times.push_back(i / rate);  // the double nearest to the decimal
    }
    BOOST_TEST(step_of(times) == 1 / rate);
  }
}

BOOST_AUTO_TEST_CASE(times_within_the_bound_are_a_step) {
  // i h = 4 exactly, where an ulp below is 2^-51 and the bound 2^-51 * 4 = 2^-49.
  BOOST_TEST(step_of({0, 2}) == 2);
  BOOST_TEST(step_of({0, 2, 4}) == 2);
  BOOST_TEST(step_of({0, 2, 4 - 3 * 0x1p-51}) == 2);
  BOOST_TEST(step_of({0, 2, 4 + 0x1p-49}) == 2);
}

BOOST_AUTO_TEST_CASE(times_beyond_the_bound_stay) {
  BOOST_TEST(step_of({0, 2, 4 - 5 * 0x1p-51}) == 0);
  BOOST_TEST(step_of({0, 2, 4 + 3 * 0x1p-50}) == 0);
  BOOST_TEST(step_of({0, 2, 4, 6, 8.000001, 10}) == 0);
  BOOST_TEST(step_of({0x1p-1000, 2, 4}) == 0);
}

BOOST_AUTO_TEST_CASE(times_come_out_in_tau) {
  const RecordOptions quarters{.clock = {.per_tau = 0.25}};  // exact: a tau is a quarter second
  const Record even = record_of("a.AT2", header + three, quarters);
  BOOST_TEST(even.step == 0.08);
  BOOST_TEST(even.times.empty());
  const Record uneven_times = record_of("a.txt", uneven, quarters);
  BOOST_TEST(uneven_times.step == 0);
  BOOST_TEST(uneven_times.times == (Samples{0, 0.4, 1}), tt::per_element());
  BOOST_TEST(record_of("a.txt", "0 1\n0.02 1\n0.04 1\n", quarters).step == 0.08);
  BOOST_TEST(record_of("a.txt", "1\n2\n", {.step = 0.02, .clock = quarters.clock}).step == 0.08);
}

BOOST_AUTO_TEST_CASE(units_are_those_of_the_values) {
  BOOST_TEST(file_of("a.AT2", measured("UNITS: GAL")).units == RecordUnits::cm_per_s2);
  BOOST_TEST(file_of("a.AT2", measured("ACCELERATION")).units == RecordUnits::g);
  BOOST_TEST(file_of("a.txt", uneven, with_units(RecordUnits::m_per_s2)).units ==
             RecordUnits::m_per_s2);
}

BOOST_AUTO_TEST_SUITE_END()
