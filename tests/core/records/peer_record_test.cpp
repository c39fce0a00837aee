// SPDX-License-Identifier: MIT
#include "record_texts.hpp"

BOOST_AUTO_TEST_SUITE(peer_record_test)

namespace {

using namespace stillpoint::test;

const std::string eight = "1 2 3 4 5 6 7 8\n9 10 11 12 13 14 15 16\n17\n";
const Samples seventeen{1, 2, 3, 4, 5, 6, 7, 8, 9, 10, 11, 12, 13, 14, 15, 16, 17};

const std::vector<Good> peer{
    right("npts_and_dt_with_keys", header + three),
    right("npts_and_dt_in_front", counted("    3    0.0100    NPTS, DT") + three, plain, 0.01),
    right("dt_in_front_of_npts", counted("0.0100 3 DT, NPTS") + three, plain, 0.01),
    right("dt_key_before_npts_key", counted("DT= .005 SEC, NPTS= 3") + three, plain, 0.005),
    right("lower_case", counted("npts= 3, dt= .02 sec") + three),
    right("no_sec", counted("NPTS= 3, DT= .02") + three),
    right("sec_with_a_comma_behind", counted("NPTS=   3, DT=   .0050 SEC, ") + three, plain, 0.005),
    right("commas_alone", counted("NPTS,3,DT,.02,SEC") + three),
    right("blanks_before_commas", counted("NPTS = 3 , DT = .02 SEC") + three),
    right("no_blanks", counted("NPTS=3,DT=.02SEC") + three),
    right("tabs", counted("NPTS=\t3,\tDT=\t.02\tSEC") + three),
    right("no_equal_signs", counted("NPTS 3 DT .02") + three),
    right("dt_in_fortran_form", counted("NPTS= 3, DT= 0.2D-01 SEC") + three),
    right("npts_in_line_7", titles + quantity +
                                "HYPOCENTRAL DISTANCE 20 KM\n\nFILTERED\nNPTS= 3, DT= .02 SEC\n" +
                                three),
    right("npts_in_line_7_in_front", titles + "A\nB\nC\n" + quantity + "3 0.02 NPTS, DT\n" + three),
    right("npts_in_a_comment_above",
          titles + "# NPTS= 9, DT= 1\n" + quantity + "NPTS= 3, DT= .02 SEC\n" + three),
    right("npts_in_longer_words_above",
          titles + "XNPTS\nNPTSX\nX_NPTS\nNPTS_X\n" + quantity + "NPTS= 3, DT= .02 SEC\n" + three),
    right("npts_behind_a_longer_word", counted("XNPTS NPTS= 3, DT= .02 SEC") + three),
    right("numbers_and_word_in_front", counted("7 8 STATION NPTS= 3, DT= .02 SEC") + three),
    right("full_stop", counted("3 0.02 NPTS, DT.") + three),
    right("npts_in_line_1", "NPTS= 3, DT= .02 SEC\n" + three),
    right("one_value_a_line", header + "0.5\n-1\n0.25\n"),
    right("eight_values_a_line", counted("17 0.01 NPTS, DT") + eight, seventeen, 0.01),
    right("uneven_lines", header + "0.5 -1\n\n0.25\n"),
    right("one_value", counted("NPTS= 1, DT= .01 SEC") + "0.5\n", {0.5}, 0.01),
    right("crlf", with_crlf(header + three)),
    right("no_final_newline", header + "0.5 -1 0.25"),
    right("byte_order_mark", "\xEF\xBB\xBF" + header + three),
    right("blank_lines_behind", header + three + "\n  \n\n"),
    right("text_behind", header + three + "END OF RECORD\n"),
    right("text_behind_that_begins_with_a_number", header + three + "3 VALUES\n1 2 3\n"),
    right("text_behind_in_the_last_line", header + "0.5 -1 0.25 END\n"),
    right("end_of_file_of_dos", with_crlf(header + three) + "\x1A"),
    right("form_feed_and_end_of_file_of_dos_behind", header + three + "END\f\n\x1A\n"),
    right("fortran_numbers", header + "-.123E-03 1.2D-3 +5.\n", {-0.000123, 0.0012, 5}, 0.02),
    right("numbers_that_touch",
          counted("NPTS= 8, DT= .02000 SEC") + "0.5-1.25 .25D-02-.5E+01+1\n -.125-100-7.\n",
          {0.5, -1.25, 0.0025, -5, 1, -0.125, -100, -7}, 0.02),
    right("numbers_that_touch_the_sign_of_an_exponent",
          counted("NPTS= 4, DT= .02000 SEC") + "1E-2-1E-2+1E+2-.5-100\n",
          {0.01, -0.01, 100, -0.5e-100}, 0.02),
    right("fortran_three_digit_exponents", header + "0.5-100 -.25+101 1.-007\n",
          {0.5e-100, -0.25e101, 1e-7}, 0.02),
};

/// `plain` in g, where the file has it in these units.
const std::vector<double> from_gal{0.5 / 980.665, -1 / 980.665, 0.25 / 980.665};
const std::vector<double> from_m_per_s2{0.5 / 9.80665, -1 / 9.80665, 0.25 / 9.80665};

const std::vector<Good> units{
    right("g_of_a_time_series", measured("ACCELERATION TIME SERIES IN UNITS OF G")),
    right("g_with_filter_points",
          measured("ACCELERATION TIME HISTORY IN UNITS OF G. FILTER POINTS: HP=0.1 Hz LP=40.0 Hz")),
    right("g_in_lower_case", measured("acceleration time history in units of g")),
    right("g_that_the_option_repeats", header + three, plain, 0.02, {}, with_units(RecordUnits::g)),
    right("cm_sec_sec", measured("ACCELERATION TIME HISTORY IN UNITS OF CM/SEC/SEC"), from_gal,
          0.02),
    right("cm_sec_2", measured("ACCELERATION TIME HISTORY IN UNITS OF CM/SEC**2"), from_gal, 0.02),
    right("cm_s_2_with_blanks", measured("UNITS: cm / s^2"), from_gal, 0.02),
    right("cm_sec_sec_in_brackets", measured("ACCELERATION (CM/SEC/SEC)"), from_gal, 0.02),
    right("cm_second_second", measured("ACCELERATION IN UNITS OF CM/SECOND/SECOND"), from_gal,
          0.02),
    right("m_seconds_2", measured("ACCELERATION IN UNITS OF M/SECONDS**2"), from_m_per_s2, 0.02),
    right("gal", measured("ACCELERATION TIME HISTORY IN GAL"), from_gal, 0.02),
    right("m_s_2", measured("ACCELERATION TIME HISTORY IN UNITS OF M/S2"), from_m_per_s2, 0.02),
    right("m_s_2_that_the_option_repeats", measured("ACCELERATION IN UNITS OF M/SEC/SEC"),
          {0.05, -0.1, 0.025}, 0.02, {}, with_units(RecordUnits::m_per_s2, 1, 10)),
    right("acceleration_that_tells_of_its_velocity",
          measured("ACCELERATION IN UNITS OF G, VELOCITY AND DISPLACEMENT SET TO ZERO AT ITS END")),
    right("time_series_alone", measured("RECORDED TIME SERIES, CM/S2"), from_gal, 0.02),
    right("units_are", measured("ACCELERATION, UNITS ARE M/S2"), from_m_per_s2, 0.02),
    right("silent_header_is_g", measured("ACCELERATION TIME HISTORY")),
    right("silent_header_and_option", measured("ACCELERATION TIME HISTORY"),
          {0.0625, -0.125, 0.03125}, 0.02, {}, with_units(RecordUnits::m_per_s2, 1, 8)),
    right("scale", header + three, {1, -2, 0.5}, 0.02, {}, scaled(2)),
    right("negative_scale", header + three, {-0.5, 1, -0.25}, 0.02, {}, scaled(-1)),
};

}  // namespace

BOOST_TEST_DECORATOR(*boost::unit_test::tolerance(4 * std::numeric_limits<double>::epsilon()))
BOOST_DATA_TEST_CASE(peer_record_is_read, data::make(peer), good) {
  check_read("record.AT2", good);
  check_read("record.txt", good);  // recognised by NPTS, not by its name
}

BOOST_TEST_DECORATOR(*boost::unit_test::tolerance(4 * std::numeric_limits<double>::epsilon()))
BOOST_DATA_TEST_CASE(peer_units_are_honoured, data::make(units), good) {
  check_read("record.at2", good);
}

BOOST_AUTO_TEST_CASE(description_of_a_peer_record_is_its_titles) {
  BOOST_TEST(file_of("a.AT2", with_crlf(header + three)).description ==
             "PEER NGA STRONG MOTION DATABASE RECORD; NOWHERE 01/02/03, SOME STATION, 090");
}

BOOST_AUTO_TEST_CASE(description_is_short_and_printable) {
  const std::string tail = "\n" + quantity + "NPTS= 3, DT= .02 SEC\n" + three;
  BOOST_TEST(file_of("a.AT2", std::string(999, 'x') + tail).description ==
             std::string(200, 'x') + "...");
  BOOST_TEST(file_of("a.AT2",
                     "Ni\xC4\x9F"
                     "de" +
                         tail,
                     {})
                 .description ==
             "Ni\xC4\x9F"
             "de");
  BOOST_TEST(file_of("a.AT2",
                     "Ni\xF0"
                     "de\fX" +
                         tail,
                     {})
                 .description == "Ni?de?X");
  // 1 + 2 * 100 bytes: the last letter does not fit.
  std::string letters = "x";
  for (int i = 0; i < 100; ++i) {
    letters += "\xC3\xA9";
  }
  BOOST_TEST(file_of("a.AT2", letters + tail).description == letters.substr(0, 199) + "...");
}

namespace {

const std::vector<Bad> wrong_peer{
    wrong("no_npts", titles + quantity + "DT= .02 SEC\n" + three,
          "line 5:...NPTS and DT are missing"),
    wrong("no_header", three, "line 1:...NPTS and DT are missing"),
    wrong("npts_too_far_down", std::string(32, '\n') + header + three,
          "line 32:...NPTS and DT are missing"),
    wrong("npts_without_number", counted("NPTS= , DT= .02 SEC") + three,
          "line 4:...NPTS has no number"),
    wrong("npts_full_of_stars", counted("NPTS= ****, DT= .02 SEC") + three,
          "line 4:...NPTS has no"),
    wrong("npts_zero", counted("NPTS= 0, DT= .02 SEC"), "line 4:...NPTS = 0...from 1"),
    wrong("npts_negative", counted("NPTS= -3, DT= .02 SEC") + three,
          "line 4:...NPTS = -3...from 1"),
    wrong("npts_broken", counted("NPTS= 3.5, DT= .02 SEC") + three, "line 4:...NPTS = 3.5...whole"),
    wrong("npts_huge", counted("NPTS= 1e300, DT= .02 SEC") + three,
          "line 4:...NPTS = 1e300...to 1000000000"),
    wrong("npts_alone", counted("NPTS= 3") + three, "line 4:...NPTS without DT"),
    wrong("dt_in_the_next_line", counted("NPTS= 3\nDT= .02 SEC") + three, "line 4:...without DT"),
    wrong("dt_without_number", counted("NPTS= 3, DT= SEC") + three, "line 4:...DT has no number"),
    wrong("dt_missing_in_front", counted("3 NPTS, DT") + three, "line 4:...NPTS has no number"),
    wrong("dt_zero", counted("3 0.0000 NPTS, DT") + three, "line 4:...DT = 0.0000...more than 0"),
    wrong("dt_negative", counted("NPTS= 3, DT= -.02 SEC") + three,
          "line 4:...DT = -.02...more than 0"),
    wrong("dt_nan", counted("NPTS= 3, DT= NaN SEC") + three, "line 4:...DT has no number"),
    wrong("dt_out_of_range", counted("NPTS= 3, DT= 1e999 SEC") + three,
          "line 4:...DT has no number"),
    wrong("dt_in_milliseconds", counted("NPTS= 3, DT= 5 MSEC") + three,
          "line 4:...\"MSEC\"...in SEC"),
    wrong("dt_in_front_in_milliseconds", counted("3 5 NPTS, DT (MS)") + three, "line 4:...\"MS\""),
    wrong("decimal_comma_in_dt", counted("NPTS= 3, DT= 0,02 SEC") + three,
          "line 4, column 14:...\"0,02\" is not a number; write a decimal comma as a point"),
    wrong("decimal_comma_that_begins_dt", counted("NPTS= 3, DT=,02 SEC") + three,
          "line 4, column 13:...\",02\" is not a number; write a decimal comma as a point"),
    wrong("decimal_comma_in_front", counted("3 0,02 NPTS, DT") + three,
          "line 4, column 3:...\"0,02\" is not a number; write a decimal comma as a point"),
    wrong("thousands_comma", counted("NPTS= 3,000, DT= .02 SEC") + three,
          "line 4, column 7:...\"3,000\" is not a number...thousands without a comma"),
    wrong("thousands_comma_in_front", counted("3,000 0.02 NPTS, DT") + three,
          "line 4, column 1:...\"3,000\" is not a number...thousands without a comma"),
    wrong("too_few_values", header + "0.5 -1\n", "line 5:...ends after 2...NPTS = 3 on line 4"),
    wrong("no_values", header, "line 4:...ends after 0...NPTS = 3"),
    wrong("far_too_few_values", counted("NPTS= 999999999, DT= .01") + three,
          "line 5:...ends after 3...NPTS = 999999999"),
    wrong("too_few_values_and_a_trailer", header + "0.5 -1\nEND\n",
          "line 6, column 1:...\"END\" is not a number...value 3 of 3"),
    wrong("too_many_values_in_a_line", header + "0.5 -1 0.25 4\n",
          "line 5:...too many values: more than NPTS = 3 on line 4"),
    wrong("too_many_values_in_more_lines", header + three + "\n4 5\n6\n\n7\nEND\n",
          "line 7:...too many values: more than NPTS = 3 on line 4"),
    wrong("too_many_values_that_are_not_finite", header + three + "NaN\n",
          "line 6:...too many values: more than NPTS = 3"),
    wrong("two_records", header + three + header + three, "line 9:...second record"),
    wrong("text_for_a_number", header + "0.5 abc 0.25\n",
          "line 5, column 5:...\"abc\" is not a number...2 of 3"),
    wrong("stars_for_a_number", header + "0.5\n*******\n0.25\n",
          "line 6, column 1:...\"*******\" is not"),
    wrong("decimal_comma", header + "0,5 -1,0 0,25\n",
          "line 5, column 1:...\"0,5\" is not a number...write a decimal comma as a point"),
    wrong("numbers_that_touch_are_counted", header + "0.5-1.25 0.25 1\n",
          "line 5:...too many values: more than NPTS = 3 on line 4"),
    wrong("two_digit_exponent_without_e", header + "0.5-03 1 1\n",
          "line 5:...too many values: more than NPTS = 3"),
    wrong("exponent_without_e_or_point", header + "5-103 1 1\n",
          "line 5:...too many values: more than NPTS = 3"),
    wrong("exponent_twice", header + "0.5E-03-100 1 1\n",
          "line 5:...too many values: more than NPTS = 3"),
    wrong("nan", header + "0.5 NaN 1\n", "line 5, column 5:...\"NaN\" is not a finite number"),
    wrong("too_large", header + "0.5\n1e400\n1\n",
          "line 6, column 1:...\"1e400\" is out of range...in g...2.2e-308 to 1e+150"),
    wrong("too_small", header + "0.5\n0.1-500\n1\n",
          "line 6, column 1:...\"0.1-500\" is out of range"),
    wrong("too_large_once_scaled", header + "0.5 1 1e300\n",
          "line 5, column 7:...\"1e300\" is out of range", scaled(1e10)),
    wrong("velocity", measured("VELOCITY TIME HISTORY IN UNITS OF CM/S"), "line 3:...a velocity"),
    wrong("velocity_in_lower_case", measured("Velocity (cm/s)"), "line 3:...a velocity"),
    wrong("velocity_without_units", measured("VELOCITY TIME HISTORY"), "line 3:...a velocity"),
    wrong("displacement", measured("DISPLACEMENT TIME SERIES IN UNITS OF CM"),
          "line 3:...a displacement"),
    wrong("units_of_a_velocity", measured("TIME HISTORY IN UNITS OF CM/S"),
          "line 3:...\"CM/S\" are those of a velocity"),
    wrong("units_of_a_velocity_behind_in", measured("TIME HISTORY IN CM/SEC"),
          "line 3:...\"CM/S\" are those of a velocity"),
    wrong("units_of_a_displacement", measured("UNITS OF CM"),
          "line 3:...\"CM\" are those of a displacement"),
    wrong("acceleration_in_units_of_a_velocity", measured("ACCELERATION IN UNITS OF M/SEC"),
          "line 3:...\"M/S\" are those of a velocity"),
    wrong("unknown_units", measured("ACCELERATION TIME HISTORY IN UNITS OF FT/S2"),
          "line 3:...\"FT/S2\" are unknown...G, CM/S2 or M/S2"),
    wrong("units_twice", titles + quantity + "UNITS: CM/S2\nNPTS= 3, DT= .02\n" + three,
          "line 4:...units of cm/s2 contradict those of line 3, g"),
    wrong("units_that_the_option_contradicts", header + three,
          "line 3:...are in g...record-units = cm/s2", with_units(RecordUnits::cm_per_s2)),
    wrong("units_that_the_option_g_contradicts", measured("UNITS OF CM/SEC/SEC"),
          "line 3:...are in cm/s2...record-units = g", with_units(RecordUnits::g)),
    wrong("step_given_as_well", header + three, "line 4:...record-step = 0.02", with_step(0.02)),
    wrong("empty", "", ": is empty"),
    wrong("blank", "\n\n", "line 2:...NPTS and DT are missing"),
    wrong("binary", "\x89PNG\r\n\x1F\x02", "line 2:...0x1F...not text"),
};

}  // namespace

BOOST_DATA_TEST_CASE(peer_record_is_refused, data::make(wrong_peer), bad) {
  check_refused("record.AT2", bad);
}

BOOST_AUTO_TEST_CASE(npts_stands_in_one_of_the_first_32_lines) {
  std::string text = "NPTS= 3, DT= .02 SEC\n" + three;
  for (int line = 1; line < 32; ++line) {
    text.insert(0, "A TITLE\n");
  }
  for (const char* name : {"a.AT2", "a.txt"}) {
    BOOST_TEST(record_of(name, text).values == plain, tt::per_element());
  }
  check_refused("b.AT2", {"", "A TITLE\n" + text, "line 32:...NPTS and DT are missing"});
  check_refused("b.txt", {"", "A TITLE\n" + text, "line 2, column 1:...\"A\" is not a number"});
}

BOOST_AUTO_TEST_SUITE_END()
