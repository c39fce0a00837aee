// SPDX-License-Identifier: MIT
#include "testing/test.hpp"

#include <stillpoint/records/number.hpp>

BOOST_AUTO_TEST_SUITE(number_test)

using namespace stillpoint::records;
using stillpoint::InputError;

/// What parsing says of a wrong value of f.
std::string refusal(const auto& parse, const char* text) {
  return stillpoint::test::refusal_of<InputError>([&] { return parse("f", text); });
}

BOOST_AUTO_TEST_CASE(both_forms_read_what_c_writes) {
  for (const auto& [text, value] :
       {std::pair{"0", 0.0}, {"-.5", -0.5}, {"+5.", 5.0}, {"1e3", 1000.0}, {"-1.25E-2", -0.0125}}) {
    for (const auto& scan : {&scan_number, &scan_fortran_number}) {
      BOOST_TEST(scan(text).fault == NumberFault::none, text);
      BOOST_TEST(scan(text).value == value, text);
    }
  }
}

BOOST_AUTO_TEST_CASE(only_fortran_has_exponents_with_d_and_without_a_letter) {
  for (const auto& [text, value] :
       {std::pair{"1.5D2", 150.0}, {"-7d-1", -0.7}, {"+.5-100", 0.5e-100}, {"1.+003", 1000.0}}) {
    BOOST_TEST(scan_fortran_number(text).fault == NumberFault::none, text);
    BOOST_TEST(scan_fortran_number(text).value == value, text);
    BOOST_TEST(scan_number(text).fault == NumberFault::no_number, text);
  }
}

BOOST_AUTO_TEST_CASE(text_is_not_a_number) {
  for (const char* text : {"", " ", "+", "-", "x", "1x", "1 ", " 1", "0x10", "1,5", "++1", "--1",
                           "1e", "1d", "12-100", "0.5-03", "1e999x"}) {
    BOOST_TEST(scan_number(text).fault == NumberFault::no_number, text);
    BOOST_TEST(scan_fortran_number(text).fault == NumberFault::no_number, text);
  }
  BOOST_TEST(scan_fortran_number("+-1").fault == NumberFault::no_number);
}

BOOST_AUTO_TEST_CASE(numbers_that_a_double_does_not_hold) {
  for (const char* text : {"1e309", "-1e309", "1e-400"}) {
    BOOST_TEST(scan_number(text).fault == NumberFault::out_of_range, text);
    BOOST_TEST(scan_fortran_number(text).fault == NumberFault::out_of_range, text);
  }
  for (const char* text : {"inf", "-infinity", "nan"}) {
    BOOST_TEST(scan_number(text).fault == NumberFault::not_finite, text);
    BOOST_TEST(scan_fortran_number(text).fault == NumberFault::not_finite, text);
  }
  // 1e-310 is subnormal: it has fewer digits than a record promises.
  BOOST_TEST(scan_number("1e-310").value == 1e-310);
  BOOST_TEST(scan_fortran_number("1e-310").fault == NumberFault::out_of_range);
}

BOOST_AUTO_TEST_CASE(value_of_a_field) {
  BOOST_TEST(parse_number("f", "+0.25") == 0.25);
  BOOST_TEST(refusal(parse_number, "abc") == "f = \"abc\": must be a number");
  BOOST_TEST(refusal(parse_number, "2.5 %") == "f = \"2.5 %\": must be a number; 2.5 % is 0.025");
  BOOST_TEST(refusal(parse_number, "x%") == "f = \"x%\": must be a number");
  BOOST_TEST(refusal(parse_number, "nan") == "f = \"nan\": must be a finite number");
  BOOST_TEST(refusal(parse_number, "1e400") ==
             "f = 1e400: must have a magnitude that a double can hold, 2.2e-308 to 1.8e308");
  BOOST_TEST(parse_integer("f", "-42") == -42);
  BOOST_TEST(parse_integer("f", "9223372036854775807") == 9223372036854775807);
  BOOST_TEST(parse_integer("f", "1.0") == 1);
  BOOST_TEST(parse_integer("f", "-1e3") == -1000);
  for (const char* text : {"", "x", "nan", "inf", "1e400"}) {
    BOOST_TEST(refusal(parse_integer, text) ==
               "f = \"" + std::string(text) + "\": must be a whole number");
  }
  for (const char* text : {"1.5", "1e-3"}) {
    BOOST_TEST(refusal(parse_integer, text) ==
               "f = " + std::string(text) + ": must be a whole number");
  }
  for (const char* text : {"9223372036854775808", "-1e19"}) {
    BOOST_TEST(refusal(parse_integer, text) ==
               "f = " + std::string(text) + ": must be a whole number of at most 18 digits");
  }
}

BOOST_AUTO_TEST_SUITE_END()
