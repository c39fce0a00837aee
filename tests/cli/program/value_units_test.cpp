// SPDX-License-Identifier: MIT
#include "cli_test.hpp"
#include "options/settings.hpp"

BOOST_AUTO_TEST_SUITE(value_units_test)

using namespace stillpoint::cli_test;
namespace cli = stillpoint::cli;

/// A number converted once between hertz or seconds and tau, and back: some roundings.
constexpr double conversion_tolerance = 1e-14;

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

BOOST_FIXTURE_TEST_CASE(trajectories_end_at_the_given_second, Sandbox) {
  const ProgramRun answer = succeed(
      "simulate --velocity 0.4 --period 2.8 --f 0.02 --delta-m 1mm --trajectory - --end-time "
      "1s --samples 11");
  BOOST_TEST(answer.out.starts_with("tau,x,v,w,absolute_acceleration,friction,t_s,x_m,"));
  const std::size_t last = answer.out.rfind('\n', answer.out.size() - 2) + 1;
  std::string line = answer.out.substr(last);
  for (int i = 0; i < 6; ++i) {
    line.erase(0, line.find(',') + 1);
  }
  BOOST_TEST(near(std::stod(line), 1, conversion_tolerance), line);
}

// With 1 t and 10 m/s2 the weight is 10 kN; of one damper commands/reports/units.txt says the same.
BOOST_FIXTURE_TEST_CASE(axes_of_friction_are_forces_and_those_of_the_notch_energies, Sandbox) {
  const Arguments hit("sweep --velocity 0.4 --period 2.8 --mass 1t --gravity 10");
  for (const auto& [force, f] :
       {std::pair{"--delta-m 5mm --friction-force 100,0.2kN", "--delta-m 5mm --f 0.01,0.02"},
        {"--delta-m 5mm --friction-force 100N:0.4kN:4", "--delta-m 5mm --f 0.01:0.04:4"},
        {"--delta-m 50J,0.1kJ --f 0.02", "--delta-m 5mm,10mm --f 0.02"},
        {"--delta-m 0:0.1kJ:3 --f 0.02", "--delta-m 0:10mm:3 --f 0.02"},
        {"--max-displacement 0.15,0.2 --f-max 200N", "--max-displacement 0.15,0.2 --f-max 0.02"}}) {
    BOOST_TEST(succeed(hit + force).out == succeed(hit + f).out, force);
  }
}

BOOST_FIXTURE_TEST_CASE(quiet_leaves_errors_alone, Sandbox) {
  write("scene.json", R"({"v0": 1, "p": 1, "beta": 0.9, "f": 0.3})");
  const ProgramRun loud = run("design scene.json");
  BOOST_TEST(contains(loud.err, "note: f"));
  BOOST_TEST(run("design scene.json --quiet").err.empty());
  check_refusal(run("design scene.json --quiet --v0 -1"), {"v0 = -1"});
}

BOOST_AUTO_TEST_SUITE_END()
