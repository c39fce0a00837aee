// SPDX-License-Identifier: MIT
#include "cli_test.hpp"
#include "options/settings.hpp"

#include <fmt/format.h>

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

// By definition: an inch is 25.4 mm, a pound 0.45359237 kg, and weighs that times 9.80665 m/s2.
BOOST_AUTO_TEST_CASE(of_inches_and_pounds_are_exact) {
  const auto value = [](const char* option, const char* text) {
    return cli::parse_value(*cli::find_option(option), text);
  };
  BOOST_TEST(near(value("max-displacement", "10in"), 0.254, conversion_tolerance));
  BOOST_TEST(near(value("max-displacement", "0.5ft"), 0.1524, conversion_tolerance));
  BOOST_TEST(
      near(value("velocity", "1ft/s"), 12 * value("velocity", "1in/s"), conversion_tolerance));
  BOOST_TEST(near(value("mass", "1000lb"), 453.59237, conversion_tolerance));
  BOOST_TEST(near(value("mass", "1kip"), 453.59237, conversion_tolerance));
  BOOST_TEST(near(value("friction-force", "1kip"), 4448.2216152605, conversion_tolerance));
  BOOST_TEST(near(value("f-max", "1000lbf"), value("f-max", "1kip"), conversion_tolerance));
  BOOST_TEST(near(value("stiffness", "1kip/in"), 4448.2216152605 / 0.0254, conversion_tolerance));
  BOOST_TEST(
      near(value("stiffness", "1000lbf/in"), value("stiffness", "1kip/in"), conversion_tolerance));
  BOOST_TEST(near(value("delta-m", "1kip-ft"), 4448.2216152605 * 0.3048, conversion_tolerance));
  BOOST_TEST(near(value("delta-m", "12lbf-in"), value("delta-m", "1lbf-ft"), conversion_tolerance));
  BOOST_TEST(near(value("gravity", "980.665gal"), 9.80665, conversion_tolerance));
  BOOST_TEST(near(value("k", "294.1995m/s2"), 30, conversion_tolerance));
  BOOST_TEST(near(value("hold", "98.0665gal"), 0.1, conversion_tolerance));
  BOOST_TEST(near(value("acceleration-max", "9.80665in/s2"), 0.0254, conversion_tolerance));
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

// With 1 t and 10 m/s2 the weight is 10 kN, so 200 N is f = 0.02 and 50 J is delta = 5 mm: one
// division, correctly rounded.
BOOST_FIXTURE_TEST_CASE(friction_is_given_as_a_force_and_the_notch_as_an_energy, Sandbox) {
  const std::string hit = " --velocity 0.4 --period 2.8 --mass 1t --gravity 10 ";
  const auto same = [&](const std::string& command, const std::string& force,
                        const std::string& f) {
    std::string expected = succeed((command + hit + f).c_str()).out;
    BOOST_TEST(succeed((command + hit + force).c_str()).out == expected, command << " " << force);
    return expected;
  };
  BOOST_TEST(contains(
      same("simulate", "--delta-m 5mm --friction-force 200", "--delta-m 5mm --f 0.02"), "200 N"));
  same("simulate", "--delta-m 5mm --friction-force 0.2kN", "--delta-m 5mm --f 0.02");
  BOOST_TEST(
      contains(same("region", "--max-displacement 0.15 --friction-force 0.0002MN --delta-m 5mm",
                    "--max-displacement 0.15 --f 0.02 --delta-m 5mm"),
               "f = 0.02 (200 N of friction)"));
  same("sweep", "--delta-m 5mm --friction-force 100,0.2kN", "--delta-m 5mm --f 0.01,0.02");
  same("sweep", "--delta-m 5mm --friction-force 100N:0.4kN:4", "--delta-m 5mm --f 0.01:0.04:4");
  same("design", "--max-displacement 0.15 --f-max 200N", "--max-displacement 0.15 --f-max 0.02");
  same("simulate", "--delta-m 50J --f 0.02", "--delta-m 5mm --f 0.02");
  same("sweep", "--delta-m 50J,0.1kJ --f 0.02", "--delta-m 5mm,10mm --f 0.02");
  same("sweep", "--delta-m 0:0.1kJ:3 --f 0.02", "--delta-m 0:10mm:3 --f 0.02");
  same("design", "--max-displacement 0.15 --delta-max-m 40J",
       "--max-displacement 0.15 --delta-max-m 4mm");
  same("design", "--max-displacement 0.15 --search-delta-m 0:0.00005MJ --scan-points 100",
       "--max-displacement 0.15 --search-delta-m 0:5mm --scan-points 100");
  same("design", "--max-displacement 0.15 --search-f 200N:300N --scan-points 100",
       "--max-displacement 0.15 --search-f 0.02:0.03 --scan-points 100");
  same("sweep", "--max-displacement 0.15,0.2 --f-max 200N",
       "--max-displacement 0.15,0.2 --f-max 0.02");
  write("force.json", R"({"max_displacement": 0.15, "f_max": "0.3kN", "friction_force": "150N",
                          "search_f": ["200N", "0.3 kN"], "scan_points": 100})");
  write("f.json", R"({"max_displacement": 0.15, "f_max": 0.03, "f": 0.015,
                      "search_f": [0.02, 0.03], "scan_points": 100})");
  same("design", "force.json", "f.json");
  write("force.json", R"({"f_max": "0.3kN", "friction_force": "150N"})");
  write("f.json", R"({"f_max": 0.03, "f": 0.015})");
  same("simulate", "force.json --delta-m 5mm", "f.json --delta-m 5mm");
  same("simulate", "force.json --delta-m 5mm --f 0.03", "f.json --delta-m 5mm --f 0.03");
}

// 1 t and 10 m/s2 as above: f is 0.02 of the report, the force is its m g.
BOOST_FIXTURE_TEST_CASE(a_spectrum_knows_the_mass, Sandbox) {
  write("record.txt", "0 0\n1 0.1\n2 -0.1\n3 0\n");
  const std::string task =
      "spectrum --record record.txt --period 1:2:3 --mass 1t --gravity 10 --delta-m 5mm ";
  const std::string answer = succeed((task + "--friction-force 200").c_str()).out;
  BOOST_TEST(answer == succeed((task + "--f 0.02").c_str()).out);
  BOOST_TEST(contains(answer, "200 N"));
}

BOOST_FIXTURE_TEST_CASE(quiet_leaves_errors_alone, Sandbox) {
  write("scene.json", R"({"v0": 1, "p": 1, "beta": 0.9, "f": 0.3})");
  const ProgramRun loud = run("design scene.json");
  BOOST_TEST(contains(loud.err, "note: f"));
  BOOST_TEST(run("design scene.json --quiet").err.empty());
  check_refusal(run("design scene.json --quiet --v0 -1"), {"v0 = -1"});
}

BOOST_AUTO_TEST_SUITE_END()
