// SPDX-License-Identifier: MIT
#include "cli_test.hpp"

BOOST_AUTO_TEST_SUITE(physical_design_test)

using namespace stillpoint::cli_test;

double number(const json& report, const char* part, const char* field) {
  return report.at(part).at(field).get<double>();
}

// An isolator of 3 s and 200 t that sets off with 0.4 m/s and has 0.16 m, worked out by hand:
// omega = 2 pi / 3, H = 0.4 / omega, time sqrt(H/g), velocity sqrt(g H), k = m omega^2.
constexpr double speed = 0.4;
constexpr double mass = 2e5;
constexpr double gravity = 9.80665;
constexpr double omega = 2.0943951023931953;
constexpr double length = 0.19098593171027440;

const Arguments isolator("design --velocity 0.4 --max-displacement 0.16");

BOOST_FIXTURE_TEST_CASE(damper_is_the_dimensionless_one_in_units, Sandbox) {
  const json report = reported(isolator + "--period 3 --mass 2e5");
  // The same problem with v0 = p = 1: f goes with omega v, delta with v^2, both over g.
  const json unit = reported("design --v0 1 --p 1 --beta 0.83775804095727800");
  const double f = number(unit, "design", "f") * omega * speed / gravity;
  const double delta_m = number(unit, "design", "delta") * speed * speed / gravity;
  const json& quantities = report["physical"];
  constexpr double digits = 1e-9;
  BOOST_TEST(near(quantities["f"], f, digits));
  BOOST_TEST(quantities["f"] == report["design"]["f"]);
  check_near(quantities,
             {{"delta_m", delta_m},
              {"friction_force_n", mass * gravity * f},
              {"energy_per_passage_j", mass * gravity * delta_m},
              {"peak_m", number(motion_of(unit), "response", "peak_amplitude") * length},
              {"stop_time_s", number(motion_of(unit), "response", "stop_time") / omega},
              {"peak_acceleration_m_per_s2",
               number(motion_of(unit), "response", "peak_acceleration") * omega * speed}},
             digits);
  BOOST_TEST(quantities["peak_m"].get<double>() <= 0.16);
}

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
