// SPDX-License-Identifier: MIT

// Where the paper's printed formulas part from its own model: docs/theory.md section 9, line by
// line.

#include "damper.hpp"

BOOST_AUTO_TEST_SUITE(published_formulas_test)

using namespace stillpoint::design_test;

/// The paper's N for f = 0, in units with H = 1.
double published_cycles(double v0, double delta) {
  return std::floor(v0 * v0 / (2 * delta)) + 1;
}

BOOST_AUTO_TEST_CASE(the_published_number_of_cycles_is_one_too_many_where_the_quotient_is_whole) {
  // V0^2 / (2 Delta) = 4: after the fourth arrival nothing is left, a fifth cycle has no amplitude.
  const auto whole = free_response({1, 0, 0.125}, {0, 1});
  BOOST_TEST(whole.half_cycles.value() == published_cycles(1, 0.125) - 1);
  BOOST_TEST(whole.half_cycles.value() == 4);
  // 1/(2 * 0.15) = 3.33: as published.
  const auto broken = free_response({1, 0, 0.15}, {0, 1});
  BOOST_TEST(broken.half_cycles.value() == published_cycles(1, 0.15));
}

BOOST_AUTO_TEST_CASE(
    the_peak_must_reach_twice_the_half_width_of_the_dead_zone_not_twice_its_width) {
  // f = 0.3, V0 = p = 1: peak 0.744, half-width 0.3: between two and four half-widths, and it
  // returns.
  const auto response = free_response({1, 0.3, 0.4}, {0, 1});
  BOOST_TEST(response.peak_amplitude > 2 * 0.3);
  BOOST_TEST(response.peak_amplitude < 4 * 0.3);
  BOOST_TEST(response.stops_at_zero);
}

BOOST_AUTO_TEST_CASE(
    constant_friction_need_not_stop_sooner_than_point_friction_of_the_same_number) {
  // H = V0/omega makes V0 = p. With p^2/(2f) = 1.99 point friction alone stops at the second
  // return, tau = 2 pi/p. Constant friction alone takes sqrt(1 + 3.98^2)/2 = 2.05, so two
  // half-swings after its first peak: 2 pi/p as well, from that peak.
  const double p = 0.3;
  const double f = p * p / (2 * 1.99);
  const auto point = free_response({p, 0, f}, {0, p});
  const auto constant = free_response({p, f, 0}, {0, p});
  BOOST_TEST(constant.peak_amplitude < 1);
  BOOST_TEST(point.half_cycles.value() == 2);
  const double first_peak = stillpoint::first_half_cycles({p, f, 0}, {0, p}, 1).front().peak_time;
  const double after_peak = constant.stop_time.value() - first_peak;
  BOOST_TEST(after_peak == point.stop_time.value(), tt::tolerance(1e-14));
  BOOST_TEST(constant.stop_time.value() > point.stop_time.value());
  // Just above the integer the claim holds.
  const double larger = p * p / (2 * 2.01);
  BOOST_TEST(free_response({p, 0, larger}, {0, p}).stop_time.value() >
             free_response({p, larger, 0}, {0, p}).stop_time.value() - first_peak);
}

BOOST_AUTO_TEST_SUITE_END()
