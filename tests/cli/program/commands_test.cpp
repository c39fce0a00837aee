// SPDX-License-Identifier: MIT
// What a command reports beyond the lines of commands/reports.
#include "cli_test.hpp"

#include <stillpoint/answers/answers.hpp>
#include <stillpoint/design/cross_check.hpp>
#include <stillpoint/design/design.hpp>
#include <stillpoint/report/report.hpp>

BOOST_FIXTURE_TEST_SUITE(commands_test, stillpoint::cli_test::Sandbox)

using namespace stillpoint::cli_test;

/// The report is still printed.
BOOST_AUTO_TEST_CASE(a_failed_cross_check_is_exit_code_4_with_a_report) {
  const stillpoint::design::Problem problem{1, 1, 0.8};
  auto result = stillpoint::design::design({problem});
  const auto& [f, delta, tolerance] = result.finding.value().point;
  auto wrong = stillpoint::design::predict(problem, f);
  wrong.peak_amplitude *= 1 + 1e-6;
  result.finding->cross_check = stillpoint::design::cross_check(wrong, problem, f, delta);
  const stillpoint::report::DesignReport failed{result};
  BOOST_TEST(stillpoint::answers::exit_code(failed) == 4);
  const auto check = stillpoint::report::json(failed)["cross_check"];
  BOOST_TEST(check["passed"] == false);
  BOOST_TEST(check["methods"][0]["passed"] == false);
}

/// For a pulse given in seconds the suggested change is in seconds, as it can be given.
BOOST_AUTO_TEST_CASE(a_duration_as_printed_makes_it_feasible) {
  const auto lasting = [](const std::string& duration) {
    return Arguments{"design", "--pulse-duration", duration} +
           "--pulse half-sine --k 0.5g --period 2.8s --max-displacement 20mm";
  };
  const ProgramRun text = ending(3, lasting("70ms"));
  const std::regex figure("pulse duration +at most ([.0-9]+) s\n");
  std::smatch found;
  BOOST_TEST_REQUIRE(std::regex_search(text.out, found, figure), text.out);
  succeed(lasting(found[1].str() + "s"));
  constexpr double beyond = 1 + 1e-4;  // five digits are printed
  BOOST_TEST(run(lasting(in_full(beyond * std::stod(found[1])) + "s")).exit_code == 3);
}

/// What the mass feels where it crosses a whole notch, followed by simulate with its edges.
BOOST_AUTO_TEST_CASE(the_bound_of_the_notch_is_what_a_passage_feels) {
  const Arguments damper("--velocity 0.4 --period 2.8 --f 0.01 --delta-m 3mm");
  const std::string text =
      std::regex_replace(run(Arguments("region --max-displacement 0.2 --arrivals 2") + damper).out,
                         std::regex("\\s+"), " ");
  std::smatch found;
  BOOST_TEST_REQUIRE(
      std::regex_search(text, found, std::regex("at most ([0-9.]+) g inside one 20 mm wide")),
      text);
  const double stated = std::stod(found[1]);
  const double felt = reported(Arguments("simulate --notch-width-m 20mm") +
                               damper)["response"]["peak_absolute_acceleration"];
  BOOST_TEST(felt <= stated);
  BOOST_TEST(felt > stated - 0.001);
}

double number(const json& report, const char* part, const char* field) {
  return report.at(part).at(field).get<double>();
}

// An isolator of 3 s and 200 t that sets off with 0.4 m/s and has 0.16 m, worked out by hand:
// omega = 2 pi / 3, H = 0.4 / omega, time sqrt(H/g), velocity sqrt(g H), k = m omega^2.
constexpr double mass = 2e5;
constexpr double gravity = 9.80665;
constexpr double omega = 2.0943951023931953;
constexpr double length = 0.19098593171027440;

const Arguments isolator("design --velocity 0.4 --max-displacement 0.16");

// After the turn at A the spring gives omega^2 A^2 and friction takes 2 g f A of the square of the
// speed; what is left is the arrival's.
BOOST_FIXTURE_TEST_CASE(values_of_practice_are_those_of_the_motion_in_units, Sandbox) {
  constexpr double digits = 1e-12;
  const json report = reported(isolator + "--period 3 --mass 2e5 --acceleration-max 0.2");
  const json& quantities = report["physical"];
  const double peak = quantities["peak_m"];
  const double force = quantities["friction_force_n"];
  const double square = omega * omega * peak * peak - 2 * force / mass * peak;
  check_near(quantities,
             {{"arrival_speed_m_per_s", std::sqrt(square)},
              {"jump_m_per_s", std::sqrt(square)},
              {"impulse_at_stop_n_s", mass * std::sqrt(square)},
              {"energy_at_stop_j", mass * square / 2},
              {"secant_stiffness_n_per_m", mass * omega * omega + force / peak},
              {"notch_width_min_m", number(report, "practice", "notch_width_min") * length}},
             digits);
  // The first passage takes the most from a damper that stops the mass at the second.
  const json second = reported(
      "region --velocity 0.4 --max-displacement 0.19 --period 3 --mass 2e5 --arrivals 2 "
      "--f 0.01 --delta-m 0.0035");
  BOOST_TEST(second["design"]["arrival"] == 2);
  const double impulse = second["physical"]["impulse_largest_n_s"];
  BOOST_TEST(near(impulse / mass / std::sqrt(gravity * length),
                  number(second, "practice", "impulse_largest"), digits));
  int rests = 0;
  for (std::size_t i = 0; i < second["hits"].size(); ++i) {
    const json& rest = second["hits"][i]["rest"];
    if (!rest.is_null()) {
      ++rests;
      BOOST_TEST(
          near(second["physical"]["hits"][i]["rest_m"], rest.get<double>() * length, digits));
    }
  }
  BOOST_TEST(rests > 0);
}

BOOST_AUTO_TEST_SUITE_END()
