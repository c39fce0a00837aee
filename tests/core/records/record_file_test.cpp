// SPDX-License-Identifier: MIT
#include "refusal.hpp"
#include "testing/folder.hpp"
#include "testing/printing.hpp"

#include <stillpoint/core/input_error.hpp>
#include <stillpoint/records/file_error.hpp>
#include <stillpoint/records/record_file.hpp>

#include <boost/test/data/monomorphic.hpp>
#include <boost/test/data/test_case.hpp>
#include <boost/test/unit_test.hpp>

#include <unistd.h>

#include <algorithm>
#include <bit>
#include <cmath>
#include <filesystem>
#include <fstream>
#include <limits>
#include <numbers>
#include <optional>
#include <ostream>
#include <random>
#include <sstream>
#include <string>
#include <system_error>
#include <vector>

BOOST_AUTO_TEST_SUITE(record_file_test)

namespace {

namespace records = stillpoint::records;
using stillpoint::InputError;
using stillpoint::Record;
using stillpoint::records::RecordFile;
using stillpoint::records::RecordOptions;
using stillpoint::records::RecordUnits;
using stillpoint::test::check_says;
using stillpoint::test::refusal_of;
namespace data = boost::unit_test::data;
namespace fs = std::filesystem;

using Numbers = std::vector<double>;
using Texts = std::vector<std::string>;

const std::string titles =
    "PEER NGA STRONG MOTION DATABASE RECORD\n"
    "NOWHERE 01/02/03, SOME STATION, 090\n";
const std::string quantity = "ACCELERATION TIME HISTORY IN UNITS OF G\n";
const std::string header = titles + quantity + "NPTS= 3, DT= .02000 SEC\n";
const std::string three = "0.5 -1 0.25\n";

/// A double as it is read back to the last bit.
std::string in_full(double value) {
  std::ostringstream text;
  text.precision(std::numeric_limits<double>::max_digits10);
  text << value;
  return text.str();
}

/// A file that is right, and what it says.
struct Good {
  const char* name;
  std::string text;
  Numbers values;
  double step;
  Numbers times{};
  RecordOptions options{};
};

/// A file that is wrong, and what the message must say.
struct Bad {
  const char* name;
  std::string text;
  Texts says;
  RecordOptions options{};
};

std::ostream& operator<<(std::ostream& stream, const Good& good) {
  return stream << good.name;
}

std::ostream& operator<<(std::ostream& stream, const Bad& bad) {
  return stream << bad.name;
}

RecordOptions with_step(double step) {
  return {.step = step};
}

RecordOptions in(RecordUnits units, double scale = 1, double gravity_m_per_s2 = 9.80665) {
  return {.units = units, .scale = scale, .gravity_m_per_s2 = gravity_m_per_s2};
}

RecordOptions with_p(double p) {
  return {.clock = {.p = p}};
}

RecordOptions scaled(double scale) {
  return {.scale = scale};
}

/// `text` with every line end turned into CR LF.
std::string with_crlf(const std::string& text) {
  std::string result;
  for (const char c : text) {
    result += c == '\n' ? std::string("\r\n") : std::string(1, c);
  }
  return result;
}

/// A header whose line with NPTS and DT is `counts`.
std::string counted(const std::string& counts) {
  return titles + quantity + counts + "\n";
}

/// A header with another line in place of the quantity, and three values.
std::string measured(const std::string& line) {
  return titles + line + "\nNPTS= 3, DT= .02000 SEC\n" + three;
}

std::string with_nul() {
  std::string text = "0 1\n0.1 2\n";
  text += '\0';
  return text;
}

const Numbers plain{0.5, -1, 0.25};

RecordFile file_of(const char* name, const std::string& text, const RecordOptions& options = {}) {
  return records::parse_record(text, name, options);
}

Record record_of(const char* name, const std::string& text, const RecordOptions& options = {}) {
  return file_of(name, text, options).record;
}

void check_read(const char* name, const Good& good) {
  const Record record = record_of(name, good.text, good.options);
  BOOST_TEST(record.values == good.values, boost::test_tools::per_element());
  BOOST_TEST(record.times == good.times, boost::test_tools::per_element());
  BOOST_TEST(record.step == good.step);
}

void check_refused(const char* name, const Bad& bad) {
  const std::string message =
      refusal_of<records::FileError>([&] { return file_of(name, bad.text, bad.options); });
  check_says(message, bad.says);
  BOOST_TEST(message.starts_with("record " + std::string(name)), message);
}

}  // namespace

// ---- PEER

namespace {

const std::string eight = "1 2 3 4 5 6 7 8\n9 10 11 12 13 14 15 16\n17\n";
const Numbers seventeen{1, 2, 3, 4, 5, 6, 7, 8, 9, 10, 11, 12, 13, 14, 15, 16, 17};

const std::vector<Good> peer{
    {"npts_and_dt_with_keys", header + three, plain, 0.02},
    {"npts_and_dt_in_front", counted("    3    0.0100    NPTS, DT") + three, plain, 0.01},
    {"dt_in_front_of_npts", counted("0.0100 3 DT, NPTS") + three, plain, 0.01},
    {"dt_key_before_npts_key", counted("DT= .005 SEC, NPTS= 3") + three, plain, 0.005},
    {"lower_case", counted("npts= 3, dt= .02 sec") + three, plain, 0.02},
    {"no_sec", counted("NPTS= 3, DT= .02") + three, plain, 0.02},
    {"sec_with_a_comma_behind", counted("NPTS=   3, DT=   .0050 SEC, ") + three, plain, 0.005},
    {"blanks_before_commas", counted("NPTS = 3 , DT = .02 SEC") + three, plain, 0.02},
    {"no_blanks", counted("NPTS=3,DT=.02SEC") + three, plain, 0.02},
    {"tabs", counted("NPTS=\t3,\tDT=\t.02\tSEC") + three, plain, 0.02},
    {"no_equal_signs", counted("NPTS 3 DT .02") + three, plain, 0.02},
    {"dt_in_fortran_form", counted("NPTS= 3, DT= 0.2D-01 SEC") + three, plain, 0.02},
    {"npts_in_line_7",
     titles + quantity + "HYPOCENTRAL DISTANCE 20 KM\n\nFILTERED\nNPTS= 3, DT= .02 SEC\n" + three,
     plain, 0.02},
    {"npts_in_line_7_in_front", titles + "A\nB\nC\n" + quantity + "3 0.02 NPTS, DT\n" + three,
     plain, 0.02},
    {"npts_in_a_comment_above",
     titles + "# NPTS= 9, DT= 1\n" + quantity + "NPTS= 3, DT= .02 SEC\n" + three, plain, 0.02},
    {"npts_in_longer_words_above",
     titles + "XNPTS\nNPTSX\nX_NPTS\nNPTS_X\n" + quantity + "NPTS= 3, DT= .02 SEC\n" + three, plain,
     0.02},
    {"npts_behind_a_longer_word", counted("XNPTS NPTS= 3, DT= .02 SEC") + three, plain, 0.02},
    {"number_and_word_in_front", counted("7 STATION NPTS= 3, DT= .02 SEC") + three, plain, 0.02},
    {"numbers_and_word_in_front", counted("7 8 STATION NPTS= 3, DT= .02 SEC") + three, plain, 0.02},
    {"full_stop", counted("3 0.02 NPTS, DT.") + three, plain, 0.02},
    {"npts_in_line_1", "NPTS= 3, DT= .02 SEC\n" + three, plain, 0.02},
    {"one_value_a_line", header + "0.5\n-1\n0.25\n", plain, 0.02},
    {"five_values_a_line",
     counted("7 0.01 NPTS, DT") + "1 2 3 4 5\n6 7\n",
     {1, 2, 3, 4, 5, 6, 7},
     0.01},
    {"eight_values_a_line", counted("17 0.01 NPTS, DT") + eight, seventeen, 0.01},
    {"uneven_lines", header + "0.5 -1\n\n0.25\n", plain, 0.02},
    {"one_value", counted("NPTS= 1, DT= .01 SEC") + "0.5\n", {0.5}, 0.01},
    {"crlf", with_crlf(header + three), plain, 0.02},
    {"no_final_newline", header + "0.5 -1 0.25", plain, 0.02},
    {"byte_order_mark", "\xEF\xBB\xBF" + header + three, plain, 0.02},
    {"blank_lines_behind", header + three + "\n  \n\n", plain, 0.02},
    {"text_behind", header + three + "END OF RECORD\n", plain, 0.02},
    {"text_behind_that_begins_with_a_number", header + three + "3 VALUES\n1 2 3\n", plain, 0.02},
    {"text_behind_in_the_last_line", header + "0.5 -1 0.25 END\n", plain, 0.02},
    {"end_of_file_of_dos", with_crlf(header + three) + "\x1A", plain, 0.02},
    {"form_feed_and_end_of_file_of_dos_behind", header + three + "END\f\n\x1A\n", plain, 0.02},
    {"fortran_numbers", header + "-.123E-03 1.2D-3 +5.\n", {-0.000123, 0.0012, 5}, 0.02},
    {"fortran_numbers_in_lower_case", header + ".5e+00 -12.d-1 7d2\n", {0.5, -1.2, 700}, 0.02},
    {"fortran_three_digit_exponents",
     header + "0.5-100 -.25+101 1.-007\n",
     {0.5e-100, -0.25e101, 1e-7},
     0.02},
};

const std::vector<Good> units{
    {"g_of_a_time_series", measured("ACCELERATION TIME SERIES IN UNITS OF G"), plain, 0.02},
    {"g_with_filter_points",
     measured("ACCELERATION TIME HISTORY IN UNITS OF G. FILTER POINTS: HP=0.1 Hz LP=40.0 Hz"),
     plain, 0.02},
    {"g_in_lower_case", measured("acceleration time history in units of g"), plain, 0.02},
    {"g_that_the_option_repeats", header + three, plain, 0.02, {}, in(RecordUnits::g)},
    {"cm_sec_sec",
     measured("ACCELERATION TIME HISTORY IN UNITS OF CM/SEC/SEC"),
     {0.5 / 980.665, -1 / 980.665, 0.25 / 980.665},
     0.02},
    {"cm_sec_2",
     measured("ACCELERATION TIME HISTORY IN UNITS OF CM/SEC**2"),
     {0.5 / 980.665, -1 / 980.665, 0.25 / 980.665},
     0.02},
    {"cm_s_2_with_blanks",
     measured("UNITS: cm / s^2"),
     {0.5 / 980.665, -1 / 980.665, 0.25 / 980.665},
     0.02},
    {"cm_sec_sec_in_brackets",
     measured("ACCELERATION (CM/SEC/SEC)"),
     {0.5 / 980.665, -1 / 980.665, 0.25 / 980.665},
     0.02},
    {"cm_second_second",
     measured("ACCELERATION IN UNITS OF CM/SECOND/SECOND"),
     {0.5 / 980.665, -1 / 980.665, 0.25 / 980.665},
     0.02},
    {"m_seconds_2",
     measured("ACCELERATION IN UNITS OF M/SECONDS**2"),
     {0.5 / 9.80665, -1 / 9.80665, 0.25 / 9.80665},
     0.02},
    {"gal",
     measured("ACCELERATION TIME HISTORY IN GAL"),
     {0.5 / 980.665, -1 / 980.665, 0.25 / 980.665},
     0.02},
    {"m_s_2",
     measured("ACCELERATION TIME HISTORY IN UNITS OF M/S2"),
     {0.5 / 9.80665, -1 / 9.80665, 0.25 / 9.80665},
     0.02},
    {"m_s_2_that_the_option_repeats",
     measured("ACCELERATION IN UNITS OF M/SEC/SEC"),
     {0.05, -0.1, 0.025},
     0.02,
     {},
     in(RecordUnits::m_per_s2, 1, 10)},
    {"acceleration_that_tells_of_its_velocity",
     measured("ACCELERATION IN UNITS OF G, VELOCITY AND DISPLACEMENT SET TO ZERO AT ITS END"),
     plain, 0.02},
    {"time_series_alone",
     measured("RECORDED TIME SERIES, CM/S2"),
     {0.5 / 980.665, -1 / 980.665, 0.25 / 980.665},
     0.02},
    {"units_are",
     measured("ACCELERATION, UNITS ARE M/S2"),
     {0.5 / 9.80665, -1 / 9.80665, 0.25 / 9.80665},
     0.02},
    {"silent_header_is_g", measured("ACCELERATION TIME HISTORY"), plain, 0.02},
    {"silent_header_and_option",
     measured("ACCELERATION TIME HISTORY"),
     {0.0625, -0.125, 0.03125},
     0.02,
     {},
     in(RecordUnits::m_per_s2, 1, 8)},
    {"scale", header + three, {1, -2, 0.5}, 0.02, {}, scaled(2)},
    {"negative_scale", header + three, {-0.5, 1, -0.25}, 0.02, {}, scaled(-1)},
};

}  // namespace

BOOST_TEST_DECORATOR(*boost::unit_test::tolerance(4 * std::numeric_limits<double>::epsilon()))
BOOST_DATA_TEST_CASE(peer_record_is_read, data::make(peer), good) {
  check_read("record.AT2", good);
  check_read("record.txt", good);  // told by NPTS, not by its name
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
    {"no_npts", titles + quantity + "DT= .02 SEC\n" + three, {"line 5:", "no NPTS and DT"}},
    {"no_header", three, {"line 1:", "no NPTS and DT"}},
    {"npts_too_far_down", std::string(32, '\n') + header + three, {"line 32:", "no NPTS and DT"}},
    {"npts_without_number",
     counted("NPTS= , DT= .02 SEC") + three,
     {"line 4:", "NPTS has no number"}},
    {"npts_full_of_stars", counted("NPTS= ****, DT= .02 SEC") + three, {"line 4:", "NPTS has no"}},
    {"npts_zero", counted("NPTS= 0, DT= .02 SEC"), {"line 4:", "NPTS = 0", "from 1"}},
    {"npts_negative", counted("NPTS= -3, DT= .02 SEC") + three, {"line 4:", "NPTS = -3", "from 1"}},
    {"npts_broken", counted("NPTS= 3.5, DT= .02 SEC") + three, {"line 4:", "NPTS = 3.5", "whole"}},
    {"npts_huge",
     counted("NPTS= 1e300, DT= .02 SEC") + three,
     {"line 4:", "NPTS = 1e300", "to 1000000000"}},
    {"npts_alone", counted("NPTS= 3") + three, {"line 4:", "NPTS without DT"}},
    {"dt_in_the_next_line", counted("NPTS= 3\nDT= .02 SEC") + three, {"line 4:", "without DT"}},
    {"dt_without_number", counted("NPTS= 3, DT= SEC") + three, {"line 4:", "DT has no number"}},
    {"dt_missing_in_front", counted("3 NPTS, DT") + three, {"line 4:", "NPTS has no number"}},
    {"dt_zero", counted("3 0.0000 NPTS, DT") + three, {"line 4:", "DT = 0.0000", "more than 0"}},
    {"dt_negative",
     counted("NPTS= 3, DT= -.02 SEC") + three,
     {"line 4:", "DT = -.02", "more than 0"}},
    {"dt_nan", counted("NPTS= 3, DT= NaN SEC") + three, {"line 4:", "DT has no number"}},
    {"dt_out_of_range", counted("NPTS= 3, DT= 1e999 SEC") + three, {"line 4:", "DT has no number"}},
    {"dt_in_milliseconds",
     counted("NPTS= 3, DT= 5 MSEC") + three,
     {"line 4:", "\"MSEC\"", "in SEC"}},
    {"dt_in_front_in_milliseconds", counted("3 5 NPTS, DT (MS)") + three, {"line 4:", "\"MS\""}},
    {"too_few_values", header + "0.5 -1\n", {"line 5:", "ends after 2", "NPTS = 3 in line 4"}},
    {"no_values", header, {"line 4:", "ends after 0", "NPTS = 3"}},
    {"far_too_few_values",
     counted("NPTS= 999999999, DT= .01") + three,
     {"line 5:", "ends after 3", "NPTS = 999999999"}},
    {"too_few_values_and_a_trailer",
     header + "0.5 -1\nEND\n",
     {"line 6, column 1:", "\"END\" is not a number", "value 3 of 3"}},
    {"too_many_values_in_a_line",
     header + "0.5 -1 0.25 4\n",
     {"line 5:", "too many values: 4", "NPTS = 3 in line 4"}},
    {"too_many_values_in_more_lines",
     header + three + "\n4 5\n6\n\n7\nEND\n",
     {"line 7:", "too many values: 7", "NPTS = 3 in line 4"}},
    {"too_many_values_that_are_not_finite",
     header + three + "NaN\n",
     {"line 6:", "too many values: 4"}},
    {"two_records", header + three + header + three, {"line 9:", "second record"}},
    {"text_for_a_number",
     header + "0.5 abc 0.25\n",
     {"line 5, column 5:", "\"abc\" is not a number", "2 of 3"}},
    {"stars_for_a_number",
     header + "0.5\n*******\n0.25\n",
     {"line 6, column 1:", "\"*******\" is not"}},
    {"decimal_comma", header + "0,5 -1,0 0,25\n", {"line 5, column 1:", "\"0,5\" is not a number"}},
    {"numbers_that_touch",
     header + "0.5-1.25 0.25\n",
     {"line 5, column 1:", "\"0.5-1.25\" is not a number"}},
    {"two_digit_exponent_without_e",
     header + "0.5-03 1 1\n",
     {"line 5, column 1:", "\"0.5-03\" is not"}},
    {"exponent_without_e_or_point",
     header + "5-103 1 1\n",
     {"line 5, column 1:", "\"5-103\" is not"}},
    {"exponent_twice",
     header + "0.5E-03-100 1 1\n",
     {"line 5, column 1:", "\"0.5E-03-100\" is not"}},
    {"two_signs", header + "+-0.5 1 1\n", {"line 5, column 1:", "\"+-0.5\" is not a number"}},
    {"hexadecimal", header + "0x10 1 1\n", {"line 5, column 1:", "\"0x10\" is not a number"}},
    {"nan", header + "0.5 NaN 1\n", {"line 5, column 5:", "\"NaN\" is not a finite number"}},
    {"infinity", header + "0.5 -inf 1\n", {"line 5, column 5:", "\"-inf\" is not a finite number"}},
    {"too_large",
     header + "0.5\n1e400\n1\n",
     {"line 6, column 1:", "\"1e400\" is out of range", "in g", "2.2e-308 to 1e+150"}},
    {"too_small",
     header + "0.5\n0.1-500\n1\n",
     {"line 6, column 1:", "\"0.1-500\" is out of range"}},
    {"too_large_once_scaled",
     header + "0.5 1 1e300\n",
     {"line 5, column 7:", "\"1e300\" is out of range"},
     scaled(1e10)},
    {"velocity", measured("VELOCITY TIME HISTORY IN UNITS OF CM/S"), {"line 3:", "a velocity"}},
    {"velocity_in_lower_case", measured("Velocity (cm/s)"), {"line 3:", "a velocity"}},
    {"velocity_without_units", measured("VELOCITY TIME HISTORY"), {"line 3:", "a velocity"}},
    {"displacement",
     measured("DISPLACEMENT TIME SERIES IN UNITS OF CM"),
     {"line 3:", "a displacement"}},
    {"units_of_a_velocity",
     measured("TIME HISTORY IN UNITS OF CM/S"),
     {"line 3:", "\"CM/S\" are those of a velocity"}},
    {"units_of_a_velocity_behind_in",
     measured("TIME HISTORY IN CM/SEC"),
     {"line 3:", "\"CM/S\" are those of a velocity"}},
    {"units_of_a_displacement",
     measured("UNITS OF CM"),
     {"line 3:", "\"CM\" are those of a displacement"}},
    {"acceleration_in_units_of_a_velocity",
     measured("ACCELERATION IN UNITS OF M/SEC"),
     {"line 3:", "\"M/S\" are those of a velocity"}},
    {"unknown_units",
     measured("ACCELERATION TIME HISTORY IN UNITS OF FT/S2"),
     {"line 3:", "\"FT/S2\" are unknown", "G, CM/S2 or M/S2"}},
    {"units_twice",
     titles + quantity + "UNITS: CM/S2\nNPTS= 3, DT= .02\n" + three,
     {"line 4:", "units of cm/s2 contradict those of line 3, g"}},
    {"units_that_the_option_contradicts",
     header + three,
     {"line 3:", "are in g", "record-units = cm/s2"},
     in(RecordUnits::cm_per_s2)},
    {"units_that_the_option_g_contradicts",
     measured("UNITS OF CM/SEC/SEC"),
     {"line 3:", "are in cm/s2", "record-units = g"},
     in(RecordUnits::g)},
    {"step_given_as_well", header + three, {"line 4:", "record-step = 0.02"}, with_step(0.02)},
    {"empty", "", {": is empty"}},
    {"blank", "\n\n", {"line 2:", "no NPTS"}},
    {"binary", "\x89PNG\r\n\x1F\x02", {"line 2:", "0x1F", "not text"}},
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
    BOOST_TEST(record_of(name, text).values == plain, boost::test_tools::per_element());
  }
  check_refused("b.AT2", {"", "A TITLE\n" + text, {"line 32:", "no NPTS"}});
  check_refused("b.txt", {"", "A TITLE\n" + text, {"line 1, column 1:", "\"A\" is not a number"}});
}

// ---- columns

namespace {

const std::string uneven = "0 0.5\n0.1 -1\n0.25 0.25\n";

const std::vector<Good> columns{
    {"time_and_value", uneven, plain, 0, {0, 0.1, 0.25}},
    {"tabs", "0\t0.5\n0.1\t-1\n0.25\t0.25\n", plain, 0, {0, 0.1, 0.25}},
    {"commas", "0,0.5\n0.1,-1\n0.25,0.25\n", plain, 0, {0, 0.1, 0.25}},
    {"commas_and_blanks", " 0 , 0.5\n0.1,\t-1 \n\t0.25 ,0.25\n", plain, 0, {0, 0.1, 0.25}},
    {"comments_and_blank_lines",
     "# a\n\n0 0.5 # b\n  # c, NPTS\n0.1 -1#d\n \t \n0.25 0.25\n\n",
     plain,
     0,
     {0, 0.1, 0.25}},
    {"crlf", with_crlf("# a\n\n" + uneven), plain, 0, {0, 0.1, 0.25}},
    {"no_final_newline", "0 0.5\n0.1 -1\n0.25 0.25", plain, 0, {0, 0.1, 0.25}},
    {"byte_order_mark", "\xEF\xBB\xBF" + uneven, plain, 0, {0, 0.1, 0.25}},
    {"fortran_numbers", "0.D0 .5E+00\n1.0D-1 -1.\n.25E0 2.5D-01\n", plain, 0, {0, 0.1, 0.25}},
    {"end_of_file_of_dos", with_crlf(uneven) + "\x1A", plain, 0, {0, 0.1, 0.25}},
    {"times_from_above_zero", "1 0.5\n2 -1\n4 0.25\n", plain, 0, {1, 2, 4}},
    {"times_one_ulp_apart",
     "1 0.5\n1.0000000000000002 -1\n3 0.25\n",
     plain,
     0,
     {1, 1 + 0x1p-52, 3}},
    {"one_row", "0 0.5\n", {0.5}, 0, {0}},
    {"uniform", "0 0.5\n0.02 -1\n0.04 0.25\n", plain, 0.02},
    {"uniform_in_other_forms", "0.000 0.5\n2e-2 -1\n4.D-2 0.25\n", plain, 0.02},
    {"uniform_from_elsewhere", "0.02 0.5\n0.04 -1\n0.06 0.25\n", plain, 0, {0.02, 0.04, 0.06}},
    {"thirds_rounded_to_four_digits",
     "0 0.5\n0.3333 -1\n0.6667 0.25\n",
     plain,
     0,
     {0, 0.3333, 0.6667}},
    {"value_alone", "0.5\n-1\n0.25\n", plain, 0.02, {}, with_step(0.02)},
    {"value_alone_with_comments", "# a\n0.5\n\n-1 # b\n0.25", plain, 0.02, {}, with_step(0.02)},
    {"value_alone_with_crlf", "0.5\r\n-1\r\n0.25\r\n", plain, 0.02, {}, with_step(0.02)},
    {"one_value", "0.5", {0.5}, 0.02, {}, with_step(0.02)},
    {"m_s_2",
     "0 1\n0.1 9.80665\n0.3 -9.80665\n",
     {1 / 9.80665, 1, -1},
     0,
     {0, 0.1, 0.3},
     in(RecordUnits::m_per_s2)},
    {"cm_s_2",
     "0 1\n0.1 980.665\n0.3 -980.665\n",
     {1 / 980.665, 1, -1},
     0,
     {0, 0.1, 0.3},
     in(RecordUnits::cm_per_s2)},
    {"cm_s_2_on_the_moon",
     "0 0\n0.1 162\n0.3 -81\n",
     {0, 1, -0.5},
     0,
     {0, 0.1, 0.3},
     in(RecordUnits::cm_per_s2, 1, 1.62)},
    {"units_and_scale",
     "0 0\n0.1 1\n0.3 -2\n",
     {0, 0.3, -0.6},
     0,
     {0, 0.1, 0.3},
     in(RecordUnits::m_per_s2, 3, 10)},
    {"values_that_are_large", "0 1e6\n0.1 -1e6\n0.3 0\n", {1e6, -1e6, 0}, 0, {0, 0.1, 0.3}},
};

const std::vector<Bad> wrong_columns{
    {"empty", "", {": is empty"}},
    {"byte_order_mark_alone", "\xEF\xBB\xBF", {": is empty"}},
    {"blank", "\n \n", {"line 2:", "without a value"}},
    {"comments_alone", "# a\n# b\n", {"line 2:", "without a value"}},
    {"heading",
     "time,acc\n0,1\n",
     {"line 1, column 1:", "\"time\" is not a number", "must begin with #"}},
    {"heading_of_three_words", "a b c\n0 1\n", {"line 1, column 1:", "\"a\" is not a number"}},
    {"text_for_a_value", "0 1\n0.1 x\n", {"line 2, column 5:", "\"x\" is not a number"}},
    {"text_for_a_time", "0 1\n# c\nx 1\n", {"line 3, column 1:", "\"x\" is not a number"}},
    {"semicolons", "0;1\n", {"line 1, column 1:", "\"0;1\" is not a number"}},
    {"line_ends_of_old_macs", "0\r1\r", {"line 1, column 1:", "\"0?1\" is not a number"}},
    {"nan", "0 1\n0.1 nan\n", {"line 2, column 5:", "\"nan\" is not a finite number"}},
    {"infinite_value", "0 1\n0.1 INF\n", {"line 2, column 5:", "\"INF\" is not a finite number"}},
    {"infinite_time",
     "0 1\ninfinity 1\n",
     {"line 2, column 1:", "\"infinity\" is not a finite number"}},
    {"value_subnormal",
     "0 1\n0.1 2.2e-308\n",
     {"line 2, column 5:", "\"2.2e-308\" is out of range"}},
    {"value_subnormal_once_scaled",
     "0 1\n0.1 3e-308\n",
     {"line 2, column 5:", "\"3e-308\" is out of range"},
     scaled(0.5)},
    {"time_negative", "-0.1 1\n0.1 1\n", {"line 1:", "time -0.1 s", "at least 0"}},
    {"value_out_of_range",
     "0 1\n0.1 -1e309\n",
     {"line 2, column 5:", "\"-1e309\" is out of range"}},
    {"time_subnormal", "2e-308 1\n1 1\n", {"line 1, column 1:", "\"2e-308\" is out of range"}},
    {"time_beyond_what_a_motion_follows",
     "0 1\n1.1e150 1\n",
     {"line 2:", "time 1.1e+150 s", "at most 1e+150"}},
    // p times the step, and the step itself, must be at least 1e-150.
    {"times_too_near", "0 1\n0.9e-150 1\n", {"line 2:", "too close to 0"}},
    {"times_too_near_for_a_slow_oscillator",
     "0 1\n0.9e-140 1\n",
     {"line 2:", "too close to 0"},
     with_p(1e-10)},
    {"times_too_near_for_a_fast_oscillator",
     "0 1\n0.9e-150 1\n",
     {"line 2:", "too close to 0"},
     with_p(1e10)},
    {"time_out_of_range", "0 1\n1e309 1\n", {"line 2, column 1:", "\"1e309\" is out of range"}},
    {"value_out_of_range_once_scaled",
     "0 1\n0.1 -1e300\n",
     {"line 2, column 5:", "\"-1e300\" is out of range"},
     scaled(1e9)},
    {"value_beyond_what_a_motion_follows",
     "0 1\n0.1 1e150\n0.2 1.1e150\n",
     {"line 3, column 5:", "\"1.1e150\" is out of range", "to 1e+150"}},
    {"value_beyond_what_a_fast_motion_follows",
     "0 1\n0.1 1.1e150\n",
     {"line 2, column 5:", "\"1.1e150\" is out of range", "to 1e+150"},
     with_p(1e10)},
    {"three_columns", "0 1 2\n", {"line 1:", "3 columns"}},
    {"five_columns", "0 1 2 3 4\n", {"line 1:", "5 columns"}, with_step(0.1)},
    {"a_column_too_many", "0 1\n0.1 2\n0.2 3 4\n", {"line 3:", "3 columns"}},
    {"a_column_too_few", "# a\n0 1\n0.1\n", {"line 3:", "1 column, but 2 in line 2"}},
    {"a_second_column", "1\n2\n3 4\n", {"line 3:", "2 columns, but 1 in line 1"}, with_step(0.1)},
    {"a_column_empty", "0,,1\n", {"line 1:", "column is empty"}},
    {"a_column_of_a_blank", "0, ,1\n", {"line 1:", "column is empty"}},
    {"a_column_empty_in_front", "0,1\n ,1\n", {"line 2:", "column is empty"}},
    {"a_column_empty_behind", "0,1\n1,\n", {"line 2:", "column is empty"}},
    {"comma_alone", ",\n", {"line 1:", "column is empty"}},
    {"time_that_stands", "0 1\n0.1 1\n0.1 2\n", {"line 3:", "time 0.1", "more than 0.1"}},
    {"time_that_goes_back", "0 1\n\n0.2 1\n0.1 2\n", {"line 4:", "time 0.1", "more than 0.2"}},
    {"step_given_with_times", "# a\n" + uneven, {"line 2:", "record-step = 0.1"}, with_step(0.1)},
    {"nul", with_nul(), {"line 3:", "0x00", "not text"}},
    {"utf_16",
     std::string("\xFF\xFE"
                 "0\0\n\0",
                 6),
     {"line 1:", "0x00", "not text"}},
    {"control_byte", "0 1\n0.1 \x07\n", {"line 2:", "0x07", "not text"}},
    {"bytes_beyond_ascii", "\xC3\x28\xFF\n", {"line 1, column 1:", "\"?(?\" is not a number"}},
    {"a_long_word",
     std::string(5000, 'x'),
     {"line 1, column 1:", std::string(60, 'x') + "...\" is not"}},
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
}

BOOST_AUTO_TEST_CASE(values_alone_need_a_step) {
  check_says(refusal_of<InputError>([] { return file_of("a.txt", "# a\n1\n2\n"); }),
             {"record-step is missing", "record a.txt", "line 2"});
}

// ---- a step in place of times

namespace {

/// The step that is read from these times.
double step_of(const Numbers& times) {
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
    Numbers times;
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
  BOOST_TEST(uneven_times.times == (Numbers{0, 0.4, 1}), boost::test_tools::per_element());
  BOOST_TEST(record_of("a.txt", "0 1\n0.02 1\n0.04 1\n", quarters).step == 0.08);
  BOOST_TEST(record_of("a.txt", "1\n2\n", {.step = 0.02, .clock = quarters.clock}).step == 0.08);
}

BOOST_AUTO_TEST_CASE(units_are_those_of_the_values) {
  BOOST_TEST(file_of("a.AT2", measured("UNITS: GAL")).units == RecordUnits::cm_per_s2);
  BOOST_TEST(file_of("a.AT2", measured("ACCELERATION")).units == RecordUnits::g);
  BOOST_TEST(file_of("a.txt", uneven, in(RecordUnits::m_per_s2)).units == RecordUnits::m_per_s2);
}

// ---- there and back

BOOST_AUTO_TEST_CASE(what_is_written_is_read_to_the_last_bit) {
  std::mt19937_64 random(20);
  Numbers values;
  Numbers times{0};
  while (values.size() < 3001) {
    // Every exponent of a value that a motion can follow and every fraction, by bits.
    const auto value = std::bit_cast<double>(random());
    if (std::isnormal(value) && std::abs(value) <= 1e150) {
      values.push_back(value);
      times.push_back(times.back() + static_cast<double>(1 + random() % 1000) / 1e5);
    }
  }
  times.pop_back();
  std::string at2 = counted("NPTS= 3001, DT= .01 SEC");
  std::string two;
  std::string one;
  for (std::size_t i = 0; i < values.size(); ++i) {
    const std::string value = in_full(values[i]);
    at2 += "  " + value + (i % 5 == 4 ? "\n" : "");
    two += in_full(times[i]) + "\t" + value + "\n";
    one += value + "\n";
  }
  BOOST_TEST((record_of("a.AT2", at2).values == values));
  BOOST_TEST((record_of("b.txt", two).values == values));
  BOOST_TEST((record_of("b.txt", two).times == times));
  BOOST_TEST(record_of("c.txt", one, with_step(0.01)).values == values);
}

// ---- files and options

BOOST_AUTO_TEST_CASE(file_that_cannot_be_read) {
  const stillpoint::test::Folder folder;
  const auto refusal = [&](const char* name) {
    return refusal_of<records::FileError>([&] { return records::read_record(folder.path(name)); });
  };
  check_says(refusal("none.AT2"), {"record ", "none.AT2: cannot be read: No such file"});
  fs::create_directory(folder.path("folder"));
  check_says(refusal("folder"), {"folder: cannot be read: Is a directory"});
  std::ofstream(folder.path("sealed.AT2")) << header << three;
  fs::permissions(folder.path("sealed.AT2"), fs::perms::none);
  if (::access(folder.path("sealed.AT2").c_str(), R_OK) == 0) {
    BOOST_TEST_MESSAGE("skipped: this user may read everything");
    return;
  }
  check_says(refusal("sealed.AT2"), {"sealed.AT2: cannot be read: Permission denied"});
}

BOOST_AUTO_TEST_CASE(file_that_is_too_large) {
  const stillpoint::test::Folder folder;
  std::ofstream(folder.path("large.AT2")).close();
  fs::resize_file(folder.path("large.AT2"), records::largest_record_bytes + 1);
  check_says(refusal_of<records::FileError>(
                 [&] { return records::read_record(folder.path("large.AT2")); }),
             {"large.AT2: is too large", "67108864 bytes"});
}

BOOST_AUTO_TEST_CASE(options_out_of_bounds) {
  const double nan = std::numeric_limits<double>::quiet_NaN();
  const double infinity = std::numeric_limits<double>::infinity();
  const auto refusal = [](const RecordOptions& options) {
    return refusal_of<InputError>([&] { return file_of("a.txt", "1\n", options); });
  };
  for (const double step : {0.0, -0.1, nan, infinity}) {
    check_says(refusal(with_step(step)), {"record-step = ", "must be from 1e-150 to 1e+150"});
  }
  const auto step_below = [](double step, double p) {
    return RecordOptions{.step = step, .clock = {.p = p}};
  };
  check_says(refusal(step_below(0.9e-140, 1e-10)), {"from 1e-140 to 1e+150 s"});
  check_says(refusal(step_below(0.9e-150, 1e10)), {"from 1e-150 to 1e+150 s"});
  for (const double scale : {0.0, 1e-101, -1e101, nan, infinity}) {
    check_says(refusal(scaled(scale)), {"record-scale = ", "from 1e-100 to 1e+100"});
  }
  for (const double gravity : {0.0, -9.8, nan, infinity}) {
    check_says(refusal(in(RecordUnits::g, 1, gravity)), {"gravity = "});
  }
}

BOOST_AUTO_TEST_CASE(units_have_names) {
  for (const RecordUnits unit : {RecordUnits::g, RecordUnits::m_per_s2, RecordUnits::cm_per_s2}) {
    BOOST_TEST(records::parse_record_units(records::name(unit)) == std::optional(unit));
  }
  for (const char* wrong : {"", "G", "cm/s", "gal"}) {
    BOOST_TEST(!records::parse_record_units(wrong).has_value());
  }
}

// ---- the records of the repository

namespace {

std::string kept(const char* name) {
  return std::string(STILLPOINT_DATA_DIR "/records/") + name;
}

}  // namespace

BOOST_AUTO_TEST_CASE(near_fault_pulse_is_the_derivative_of_its_velocity) {
  const Record record = records::read_record(kept("near_fault_pulse.txt")).record;
  BOOST_TEST_REQUIRE(record.values.size() == 1201U);
  BOOST_TEST(record.step == 0.01);
  // v = A/2 (1 + cos(pi s / 2)) cos(pi s + pi/2) with A = 0.9 m/s, s = t - 4 and |s| <= 2. The
  // trapezoidal rule is off by h^2/12 |v''|, and |v''| <= 0.45 (1 + 9/8 + 1/8) pi^2 < 10 m/s^3.
  constexpr double tolerance_m_per_s = 1e-4;
  constexpr double pi = std::numbers::pi;
  double velocity = 0;
  for (std::size_t i = 1; i < record.values.size(); ++i) {
    velocity += 9.80665 * record.step * (record.values[i - 1] + record.values[i]) / 2;
    const double s = static_cast<double>(i) * record.step - 4;
    const double expected =
        std::abs(s) <= 2 ? -0.45 * (1 + std::cos(pi * s / 2)) * std::sin(pi * s) : 0;
    BOOST_TEST(std::abs(velocity - expected) <= tolerance_m_per_s,
               "at s = " << s << ": " << velocity << ", not " << expected);
  }
}

BOOST_AUTO_TEST_CASE(strong_motion_is_as_its_script_says) {
  const RecordFile file = records::read_record(kept("strong_motion.AT2"));
  BOOST_TEST(file.units == RecordUnits::g);
  BOOST_TEST(file.record.values.size() == 2000U);
  BOOST_TEST(file.record.step == 0.01);
  double peak = 0;
  for (const double value : file.record.values) {
    peak = std::max(peak, std::abs(value));
  }
  BOOST_TEST(peak == 0.35);
  BOOST_TEST(file.description.starts_with("SYNTHETIC RECORD, NO EARTHQUAKE"));
}

BOOST_AUTO_TEST_SUITE_END()
