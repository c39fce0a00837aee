// SPDX-License-Identifier: MIT
#include "testing/exact.hpp"
#include "testing/test.hpp"

#include <stillpoint/records/decimal.hpp>

BOOST_AUTO_TEST_SUITE(decimal_test)

using namespace stillpoint::records;
using stillpoint::test::Exact;

constexpr double infinity = std::numeric_limits<double>::infinity();
constexpr double largest = std::numeric_limits<double>::max();

BOOST_AUTO_TEST_CASE(a_third_in_six_digits) {
  BOOST_TEST(decimal(1.0 / 3, 6) == 0.333333);
  BOOST_TEST(decimal(1.0 / 3, 6, Rounding::down) == 0.333333);
  BOOST_TEST(decimal(1.0 / 3, 6, Rounding::up) == 0.333334);
  BOOST_TEST(decimal(-1.0 / 3, 6, Rounding::down) == -0.333334);
  BOOST_TEST(decimal(-1.0 / 3, 6, Rounding::up) == -0.333333);
}

BOOST_AUTO_TEST_CASE(a_decimal_stays_as_it_is) {
  for (const double value : {0.0, 0.1, -0.3, 150.0, 1.2e-300, 1e22, 1.23457e+30}) {
    for (const Rounding rounding : {Rounding::nearest, Rounding::up, Rounding::down}) {
      BOOST_TEST(decimal(value, 6, rounding) == value);
    }
  }
}

BOOST_AUTO_TEST_CASE(where_no_double_is_that_decimal_the_value_stays) {
  BOOST_TEST(decimal(largest, 3, Rounding::up) == largest);  // not 1.80e308
  BOOST_TEST(decimal(infinity, 6, Rounding::down) == infinity);
}

/// On the side asked for, less than one of the last digit away, and the double nearest to a decimal
/// of so many digits: that value times a power of ten, in many digits, is whole but for its own
/// rounding.
BOOST_AUTO_TEST_CASE(rounded_decimals_are_the_next_ones) {
  std::mt19937 random(20'261'126);
  std::uniform_real_distribution<double> exponents(-290, 290);
  std::uniform_int_distribution<int> lengths(1, 15);
  std::bernoulli_distribution negative;
  for (int i = 0; i < 3000; ++i) {
    const double value = (negative(random) ? -1 : 1) * std::pow(10, exponents(random));
    const int digits = lengths(random);
    const double up = decimal(value, digits, Rounding::up);
    const double down = decimal(value, digits, Rounding::down);
    const Exact unit = pow(Exact(10), floor(log10(abs(Exact(value)))) - (digits - 1));
    const Exact rounding = Exact(std::abs(value)) * 0x1p-52;
    BOOST_TEST(down <= value, i);
    BOOST_TEST(value <= up, i);
    BOOST_TEST(Exact(up) - Exact(down) <= unit + 2 * rounding, i);
    const double nearest = decimal(value, digits);
    BOOST_TEST((nearest == up || nearest == down), i);
    BOOST_TEST(abs(Exact(nearest) - Exact(value)) <= unit / 2 + rounding, i);
    for (const double found : {up, down}) {
      BOOST_TEST(abs(Exact(found) - unit * round(Exact(found) / unit)) <= rounding, i);
    }
  }
}

BOOST_AUTO_TEST_SUITE_END()
