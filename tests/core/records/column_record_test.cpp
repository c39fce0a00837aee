// SPDX-License-Identifier: MIT
#include "record_texts.hpp"

BOOST_AUTO_TEST_SUITE(column_record_test)

using namespace stillpoint::test;

BOOST_TEST_DECORATOR(*boost::unit_test::tolerance(4 * std::numeric_limits<double>::epsilon()))
BOOST_AUTO_TEST_CASE(columns_are_read) {
  check_read("columns.txt", {"record.txt"});
}

BOOST_AUTO_TEST_CASE(columns_are_refused) {
  check_refused("columns_wrong.txt", "record.txt");
  // A long word is quoted in part.
  const std::string quoted = std::string(60, 'x') + "...\" is not";
  check_refused("record.txt", {.name = "",
                               .text = "t\n" + std::string(5000, 'x'),
                               .says = "line 2, column 1:..." + quoted});
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
  BOOST_TEST(doubt("# in m/s2\n" + uneven, {.units = RecordUnits::m_per_s2}) == "");
  BOOST_TEST(doubt("# in m/s2\n" + uneven, {.units = RecordUnits::g}) == "");
  // Of a slow wave neighbours are alike, and in a table of two waves the numbers of a column.
  std::string sequence;
  std::string table;
  for (int i = 0; i < 400; ++i) {
    const std::string value = in_full(std::sin(0.05 * i));
    sequence += value + (i % 4 == 3 ? "\n" : " ");
    table += value + " " + in_full(2 + std::cos(0.05 * i)) + "\n";
  }
  BOOST_TEST(doubt(sequence, {.step = 0.01}) == "");
  check_says(doubt(table, {.step = 0.01}),
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
  BOOST_TEST(file_of("a.txt", uneven, {.units = RecordUnits::m_per_s2}).units ==
             RecordUnits::m_per_s2);
}

BOOST_AUTO_TEST_SUITE_END()
