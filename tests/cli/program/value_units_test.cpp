// SPDX-License-Identifier: MIT
#include "cli_test.hpp"
#include "options/settings.hpp"

#include <fmt/format.h>

BOOST_AUTO_TEST_SUITE(value_units_test)

namespace {

using namespace stillpoint::cli_test;
namespace cli = stillpoint::cli;

/// A number converted once between hertz or seconds and tau, and back: some roundings.
constexpr double conversion_tolerance = 1e-14;

const Arguments isolator("design --velocity 0.4 --period 2.8 --max-displacement 0.15 --mass 1.2e6");

Arguments forced(const Arguments& more) {
  return "simulate --period 2.8 --f 0.02 --delta-m 0.001 --k 0.1" + more;
}

}  // namespace

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
        const double expected = std::strtod(plain.c_str(), nullptr);
        BOOST_TEST(cli::parse_value(option, number + std::string(unit.name)) == expected,
                   option.name << " " << number << unit.name << ", seed " << seed);
        BOOST_TEST(cli::parse_value(option, number + " " + std::string(unit.name)) == expected);
      }
    }
  }
  BOOST_TEST(tried > 3000);
}

BOOST_FIXTURE_TEST_CASE(with_values_make_the_same_report, Sandbox) {
  const json plain = without_wall_times(reported(isolator));
  for (const Arguments& given : std::vector<Arguments>{{"400mm/s", "2.8s", "150mm", "1200t"},
                                                       {"0.4m/s", "2800ms", "15cm", "1200000kg"},
                                                       {"40cm/s", "2800 ms", "0.15m", "1.2e9g"}}) {
    const Arguments arguments{"design",   "--velocity", given[0],
                              "--period", given[1],     "--max-displacement",
                              given[2],   "--mass",     given[3]};
    BOOST_TEST(without_wall_times(reported(arguments)) == plain, given[0]);
  }
  write("scene.json", R"(// an isolator
    {"velocity": "400mm/s", /* slow */ "period": "2.8s", "max_displacement": "150mm", "mass": "1200t"})");
  BOOST_TEST(without_wall_times(reported("design scene.json")) == plain);
  // The flag's number, not what the scene had in another unit.
  BOOST_TEST(reported("design scene.json --period 3")["physical"]["period_s"] == 3);
  succeed("design scene.json --html page.html");
  BOOST_TEST(contains(read("page.html"), "150mm"));
}

BOOST_FIXTURE_TEST_CASE(natural_frequency_gives_the_period, Sandbox) {
  // 1/4 and 4 are exact.
  const Arguments rest("--velocity 0.4 --max-displacement 0.2");
  BOOST_TEST(without_wall_times(reported("design --natural-frequency 0.25Hz" + rest)) ==
             without_wall_times(reported("design --period 4s" + rest)));
}

// A frequency in hertz is lambda/(2 pi) over a unit of time; a half-sine lasts pi/lambda of them, a
// full sine twice that.
BOOST_FIXTURE_TEST_CASE(frequencies_and_durations_are_those_of_the_load, Sandbox) {
  for (const auto& [type, periods] :
       {std::pair{"half-sine", 0.5}, std::pair{"rectangle", 0.5}, std::pair{"full-sine", 1.0}}) {
    const json by_duration = reported(forced({"--excitation", type, "--pulse-duration", "70ms"}));
    const json& physical = by_duration["physical"];
    BOOST_TEST(near(physical["excitation_duration_s"], 0.07, conversion_tolerance));
    BOOST_TEST(near(physical["excitation_frequency_hz"], periods / 0.07, conversion_tolerance));
    const double lambda = by_duration["input"]["excitation"]["lambda"];
    BOOST_TEST(reported(forced({"--excitation", type, "--lambda", in_full(lambda)})) ==
               by_duration);
    const json by_frequency =
        reported(forced({"--excitation", type, "--excitation-frequency", in_full(periods / 0.07)}));
    BOOST_TEST(near(by_frequency["input"]["excitation"]["lambda"], lambda, conversion_tolerance));
  }
  const json harmonic =
      reported(forced("--excitation harmonic --excitation-frequency 0.36Hz "
                      "--excitation-duration 20s --end-time 30000ms"));
  check_near(harmonic["physical"],
             {{"excitation_frequency_hz", 0.36}, {"excitation_duration_s", 20}, {"end_time_s", 30}},
             conversion_tolerance);
  // As keys of a scene, flat or in an object, with a flag that takes their place.
  write("flat.json", R"({"period": "2.8s", "f": 0.02, "delta_m": "1mm", "excitation": "harmonic",
      "k": "0.1g", "excitation_frequency": "0.36Hz", "excitation_duration": 20, "end_time": "30s"})");
  write("object.json", R"({"period": "2.8s", "f": 0.02, "delta_m": "1mm", "excitation": {
      "type": "harmonic", "k": "0.1g", "excitation_frequency": "0.36Hz", "excitation_duration": 20,
      "end_time": "30s"}})");
  BOOST_TEST(reported("simulate flat.json") == harmonic);
  BOOST_TEST(reported("simulate object.json") == harmonic);
  BOOST_TEST(reported("simulate flat.json --lambda 2")["input"]["excitation"]["lambda"] == 2);
}

BOOST_FIXTURE_TEST_CASE(trajectories_end_at_the_given_second, Sandbox) {
  const ProgramRun answer = succeed(
      "simulate --velocity 0.4 --period 2.8 --f 0.02 --delta-m 1mm --trajectory - --end-time "
      "1s --samples 11");
  BOOST_TEST(answer.out.starts_with("tau,x,v,t_s,x_m,v_m_per_s\n"));
  const std::size_t last = answer.out.rfind('\n', answer.out.size() - 2) + 1;
  std::string line = answer.out.substr(last);
  for (int i = 0; i < 3; ++i) {
    line.erase(0, line.find(',') + 1);
  }
  BOOST_TEST(near(std::stod(line), 1, conversion_tolerance), line);
}

BOOST_FIXTURE_TEST_CASE(quiet_leaves_errors_alone, Sandbox) {
  write("scene.json", R"({"v0": 1, "p": 1, "beta": 0.9, "f": 0.3})");
  const ProgramRun loud = run("design scene.json");
  BOOST_TEST(contains(loud.err, "note: f"));
  BOOST_TEST(run("design scene.json --quiet").err.empty());
  check_refusal(run("design scene.json --quiet --v0 -1"), {"v0 = -1"});
}

BOOST_AUTO_TEST_SUITE_END()
