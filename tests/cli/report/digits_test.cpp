// SPDX-License-Identifier: MIT
#include "testing/test.hpp"

#include <stillpoint/report/digits.hpp>

BOOST_AUTO_TEST_SUITE(digits_test)

using namespace stillpoint::report;

BOOST_AUTO_TEST_CASE(six_digits) {
  BOOST_TEST(digits(0.2593254) == "0.259325");
  BOOST_TEST(digits(1.2e-9) == "1.2e-09");
}

BOOST_AUTO_TEST_CASE(four_digits_without_an_exponent_below_a_million) {
  BOOST_TEST(few_digits(0.2593254) == "0.2593");
  BOOST_TEST(few_digits(19238.2) == "19240");
  BOOST_TEST(few_digits(-999949) == "-999900");
  BOOST_TEST(few_digits(999950) == "1e+06");
  BOOST_TEST(few_digits(1.2e-9) == "1.2e-09");
}

BOOST_AUTO_TEST_CASE(an_interval_has_the_digits_that_its_width_needs) {
  BOOST_TEST(interval_digits(0.34015, 0.42925) == "0.341 to 0.429");
  BOOST_TEST(interval_digits(0.99996, 1.00004) == "0.99996 to 1.00004");
  BOOST_TEST(interval_digits(0, 2) == "up to 2");
  BOOST_TEST(interval_digits(0.5, 0.5) == "0.5");
}

BOOST_AUTO_TEST_CASE(ends_that_differ_are_printed_differently) {
  BOOST_TEST(interval_digits(0.0158739, 0.3, 6) == "0.0158739 to 0.3");
  BOOST_TEST(interval_digits(0.35355338937, 0.35355339059, 6) == "0.35355338937 to 0.35355339059");
  BOOST_TEST(interval_digits(0.3, 0.3, 6) == "0.3");
  // Nobody can build less than a millionth of the most.
  BOOST_TEST(interval_digits(5e-11, 0.0171893, 6) == "up to 0.0171893");
  BOOST_TEST(interval_digits(0, 2.5e-10, 6) == "up to 2.5e-10");
  BOOST_TEST(interval_digits(2e-6, 1, 6) == "2e-06 to 1");
}

/// Both printed ends lie in the range, whatever it is, and most of it lies between them.
BOOST_AUTO_TEST_CASE(printed_ranges_lie_within) {
  std::mt19937 random(20'261'123);
  std::uniform_real_distribution<double> exponents(-12, 12);
  std::uniform_real_distribution<double> widths(-14, 2);
  for (int i = 0; i < 4000; ++i) {
    const double low = std::pow(10, exponents(random));
    const double high = low * (1 + std::pow(10, widths(random)));
    for (const std::string& text : {interval_digits(low, high), interval_digits(low, high, 6)}) {
      const double from = std::stod(text);
      const double to = std::stod(text.substr(text.rfind(' ')));
      BOOST_TEST(low <= from, text);
      BOOST_TEST(from <= to, text);
      BOOST_TEST(to <= high, text);
    }
    const double within = decimal_within(low, high);
    BOOST_TEST(low <= within);
    BOOST_TEST(within <= high);
  }
  BOOST_TEST(decimal_within(0.35355338937, 0.35355339059) == 0.35355339);
  BOOST_TEST(decimal_within(0.5, 0.5) == 0.5);
  BOOST_TEST(decimal_within(1.0 / 3, 1.0 / 3) == 1.0 / 3);
}

BOOST_AUTO_TEST_CASE(units_take_the_prefix_that_fits) {
  BOOST_TEST(with_unit(0.0121, "m") == "12.1 mm");
  BOOST_TEST(with_unit(-0.0121, "m") == "-12.1 mm");
  BOOST_TEST(with_unit(3460, "N") == "3.46 kN");
  BOOST_TEST(with_unit(1, "s") == "1 s");
  BOOST_TEST(with_unit(2e-6, "J") == "2 uJ");
  BOOST_TEST(with_unit(2e-7, "s") == "200 ns");
  BOOST_TEST(with_unit(2e-7, "m") == "0.0002 mm");
  BOOST_TEST(with_unit(0.99999999e-3, "m") == "1 mm");  // not 1000 um
  BOOST_TEST(with_unit(999.9999, "N") == "1 kN");
}

BOOST_AUTO_TEST_CASE(there_are_no_kilometres_and_no_prefix_beyond_giga_and_nano) {
  BOOST_TEST(with_unit(3460, "m") == "3460 m");
  BOOST_TEST(with_unit(1212.4, "s") == "1212.4 s");
  BOOST_TEST(with_unit(2e12, "N") == "2e+12 N");
  BOOST_TEST(with_unit(2e-10, "m") == "2e-10 m");
  BOOST_TEST(with_unit(0, "m") == "0 m");
}

/// Whatever the value, the printed limit lies on the side that meets it, within 1.5 of the tenth
/// digit.
BOOST_AUTO_TEST_CASE(a_printed_limit_is_on_the_safe_side) {
  constexpr double tenth_digit = 1.5e-9;  // relative, of a value that begins with 1
  std::mt19937 random(20'261'121);
  std::uniform_real_distribution<double> exponents(-20, 20);
  for (int i = 0; i < 2000; ++i) {
    const double value = std::pow(10, exponents(random));
    const double least = std::stod(limit_digits(value, true));
    const double most = std::stod(limit_digits(value, false));
    BOOST_TEST(least >= value);
    BOOST_TEST(most <= value);
    BOOST_TEST(least - most <= 2 * tenth_digit * value, value);
  }
  BOOST_TEST(limit_digits(0.5, true) == "0.5");
  BOOST_TEST(limit_digits(1.0 / 3, true) == "0.3333333334");
  BOOST_TEST(limit_digits(1.0 / 3, false) == "0.3333333333");
  BOOST_TEST(limit_digits(1 / 1.1, true, 3) == "0.91");  // 0.909090...
  BOOST_TEST(limit_digits(1 / 1.1, false, 3) == "0.909");
}

BOOST_AUTO_TEST_CASE(counts_are_whole_as_long_as_they_are_exact) {
  BOOST_TEST(plural(9007199254740992.0, "turn") == "9007199254740992 turns");  // 2^53
  BOOST_TEST(plural(1e17, "turn") == "1e+17 turns");
  BOOST_TEST(plural({}, "turn") == "none turns");
  BOOST_TEST(plural(1.0, "turning point") == "1 turning point");
  BOOST_TEST(plural(0.0, "passage") == "0 passages");
}

BOOST_AUTO_TEST_SUITE_END()
