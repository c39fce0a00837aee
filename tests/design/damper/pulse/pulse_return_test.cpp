// SPDX-License-Identifier: MIT
#include "damper.hpp"
#include "pulse/edge.hpp"
#include "pulse/first_return.hpp"
#include "pulse_task.hpp"

BOOST_AUTO_TEST_SUITE(pulse_return_test)

// The first return in closed form, compared with the forced motion, which looks for every event.

using namespace stillpoint::design_test;

/// About ten roundings of the pieces, and those of the time of a slow return: lambda times the
/// rounding of the velocity that a full sine leaves, the difference of its halves.
constexpr double rounding = 1e-12;
/// Closer than this to another kind of motion, either may be right.
constexpr double undecided = 1e-10;
/// Shorter full sines are left to the forced motion.
constexpr double shortest = 1e3;

BOOST_AUTO_TEST_CASE(random_motions_are_those_of_the_forced_run) {
  RandomSource random(20261122);
  std::array<int, 3> closed{};
  std::array<int, 3> returned{};
  for (int i = 0; i < 30'000; ++i) {
    const double lambda = std::pow(10, random.uniform(-2, i % 2 == 0 ? 0.5 : 4));
    const double f = i % 3 == 0 ? random.uniform(0, 0.999)
                                : std::min(0.999, std::pow(10, random.uniform(-5, 0.3)) / lambda);
    const Pulse pulse = pulse_of(random.pick(3), 1, lambda);
    const auto found = closed_return(pulse, f);
    const ForcedResponse motion = forced_response({1, f, 1e200}, {}, excitation(pulse));
    BOOST_TEST(found.has_value() == (lambda <= shortest || pulse.index() != 1));
    if (!found || motion.decision_margin.value_or(0) < undecided) {
      continue;
    }
    ++closed[pulse.index()];
    // Both as in the cross-check: (31), and what an f barely below k amplifies.
    const double allowed = rounding * std::max(1.0, f / std::max(found->speed, 1e-9 * f)) / (1 - f);
    BOOST_TEST_CONTEXT("run " << i << ", " << name(pulse) << ", lambda " << lambda << ", f " << f) {
      BOOST_TEST(found->returns == (motion.stops_at_zero && motion.half_cycles == 1.0));
      BOOST_TEST(found->turns == motion.turning_points.value_or(0));
      BOOST_TEST(std::abs(found->peak / motion.peak_amplitude - 1) <= allowed);
      BOOST_TEST(std::abs(found->acceleration / motion.peak_absolute_acceleration - 1) <= allowed);
      BOOST_TEST(std::abs(found->published_need - found->exact_need - f * f / 2) <= allowed);
      if (found->returns) {
        ++returned[pulse.index()];
        BOOST_TEST(std::abs(found->exact_need - found->speed * found->speed / 2) <= allowed);
        BOOST_TEST(std::abs(found->speed - motion.arrival_speed.value()) <= allowed * found->peak);
        BOOST_TEST(std::abs(found->time / motion.stop_time.value() - 1) <= allowed);
      } else {
        const double rest = std::abs(motion.stop_position.value());
        BOOST_TEST(std::abs(found->clearance - rest * (rest - 2 * f)) <= allowed * found->peak);
      }
    }
  }
  BOOST_TEST(!closed_return(HalfSine{1, 1}, 1).has_value());
  BOOST_TEST(*std::ranges::min_element(closed) >= 3000);
  BOOST_TEST(*std::ranges::min_element(returned) >= 2500);
}

// Under a half-sine with lambda = p, y = (sin t - t cos t)/2 - f (1 - cos t) but for f^3: the mass
// turns f^2/pi before the load ends, at A = pi/2 - 2 f, and comes back with w^2 = A (A - 2 f).
BOOST_AUTO_TEST_CASE(a_half_sine_of_half_a_natural_period_ends_where_the_mass_turns) {
  for (const double f : {1e-5, 1e-6, 1e-7, 1e-8, 1e-9, 1e-12}) {
    const FirstReturn found = closed_return(HalfSine{1, 1}, f).value();
    const double peak = std::numbers::pi / 2 - 2 * f;
    const auto close = tt::tolerance(1e-14);
    BOOST_TEST(found.returns);
    BOOST_TEST(found.peak == peak, close);
    BOOST_TEST(found.speed == std::sqrt(peak * (peak - 2 * f)), close);
  }
}

// Without friction it comes back after a whole swing about 1, which ends at x = 0 without speed;
// with the least friction it turns 4 f short of it and returns only with the energy that the load
// leaves it, w^2/2 = 1 - cos(pi/lambda).
BOOST_AUTO_TEST_CASE(a_rectangle_longer_than_a_swing_ends_it_at_zero_only_without_friction) {
  for (const double lambda : {0.45, 0.4, 0.3, 0.07}) {
    const Rectangle pulse{1, lambda};
    const auto stops_at_first_return = [&](double f, double delta) {
      const ForcedResponse motion = forced_response({1, f, delta}, {}, pulse);
      return motion.stops_at_zero && motion.half_cycles == 1.0;
    };
    const FirstReturn without = closed_return(pulse, 0).value();
    const double swing = 2 * std::numbers::pi;
    BOOST_TEST(without.returns);
    BOOST_TEST(without.speed == 0);
    BOOST_TEST(without.exact_need == 0);
    BOOST_TEST(without.published_need == 0);
    BOOST_TEST(without.time == swing, tt::tolerance(1e-15));
    BOOST_TEST(without.peak == 2);
    BOOST_TEST(without.acceleration == 2);
    // The kernel's rounding leaves it a speed of 1e-8.
    BOOST_TEST(stops_at_first_return(0, 1e-12));

    constexpr double f = 1e-7;
    const double need = closed_return(pulse, f).value().exact_need;
    const double swings = std::numbers::pi / lambda / swing;
    BOOST_TEST(std::abs(need - (1 - std::cos(std::numbers::pi / lambda))) <= 20 * swings * f);
    BOOST_TEST(stops_at_first_return(f, need * (1 + 1e-9)));
    BOOST_TEST(!stops_at_first_return(f, need * (1 - 1e-9)));
  }
}

// Its root, from either side, in a handful of steps: where the function jumps in some fifty.
BOOST_AUTO_TEST_CASE(an_edge_is_the_last_place_that_is_not_negative) {
  int calls = 0;
  const auto smooth = [&](double x) {
    ++calls;
    return std::cos(x) - x;
  };
  constexpr double fixed_point = 0.73908513321516064166;
  BOOST_TEST(last_not_negative(0.0, 1.0, smooth) == fixed_point, tt::tolerance(1e-14));
  BOOST_TEST(std::cos(last_not_negative(0.0, 1.0, smooth)) >= last_not_negative(0.0, 1.0, smooth));
  BOOST_TEST(calls <= 3 * 14);
  const auto jump = [&](double x) { return x > 0.3 ? 1e-300 : -1.0; };
  const double edge = last_not_negative(1.0, 0.0, jump);
  BOOST_TEST(edge > 0.3);
  BOOST_TEST(edge == 0.3, tt::tolerance(2e-14));
}

BOOST_AUTO_TEST_SUITE_END()
