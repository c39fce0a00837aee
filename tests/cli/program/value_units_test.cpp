// SPDX-License-Identifier: MIT
#include "cli_test.hpp"
#include "options/settings.hpp"

BOOST_AUTO_TEST_SUITE(value_units_test)

using namespace stillpoint::cli_test;
namespace cli = stillpoint::cli;

// The C library rounds the decimal 1.5e-1 correctly; so must 150e-3 and 150mm.
BOOST_AUTO_TEST_CASE(scales_decimal_digits_not_doubles) {
  constexpr unsigned seed = 20261122;
  std::mt19937_64 random(seed);
  std::uniform_int_distribution<std::int64_t> mantissa(-999'999'999'999, 999'999'999'999);
  std::uniform_int_distribution<int> exponent(-30, 30);
  std::uniform_int_distribution<int> form(0, 3);
  int tried = 0;
  for (const cli::Option& option : cli::options()) {
    for (const stillpoint::records::Unit& unit :
         stillpoint::records::units_of(option.traits.dimension)) {
      for (int i = 0; i < 100; ++i, ++tried) {
        const std::int64_t digits = mantissa(random);
        const int e = exponent(random);
        // 12345e-3, 12345.0E-3, +12345.e-3 and 12345
        const int how = form(random);
        const std::string number = how == 0   ? fmt::format("{}e{}", digits, e)
                                   : how == 1 ? fmt::format("{}.0E{:+}", digits, e)
                                   : how == 2 ? fmt::format("{}.e{}", digits, e)
                                              : fmt::format("{}", digits);
        const int power = unit.power_of_ten + (how == 3 ? 0 : e);
        const std::string plain = fmt::format("{}e{}", digits, power);
        const double expected = std::strtod(plain.c_str(), nullptr) * unit.times;
        BOOST_TEST(cli::parse_value(option, number + std::string(unit.name)) == expected,
                   option.name << " " << number << unit.name << ", seed " << seed);
        BOOST_TEST(cli::parse_value(option, number + " " + std::string(unit.name)) == expected);
      }
    }
  }
  BOOST_TEST(tried > 3000);
}

BOOST_AUTO_TEST_SUITE_END()
