// SPDX-License-Identifier: MIT
#include "motion.hpp"

#include "kernel/damped_piece.hpp"

#include <stillpoint/core/forced_motion.hpp>
#include <stillpoint/core/free_motion.hpp>
#include <stillpoint/core/half_cycles.hpp>
#include <stillpoint/core/input_error.hpp>
#include <stillpoint/core/trajectory.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <numbers>
#include <vector>

// Free motions with damping and with breakaway friction: docs/damping.md.

namespace stillpoint::test {

BOOST_AUTO_TEST_SUITE(damped_motion_test)

constexpr double sixteen_digits = 4e-16;  // of values of about 1
constexpr double nine_digits = 1e-9;

Oscillator damped(double zeta, double f, double delta, double p = 1) {
  return {.p = p, .f = f, .delta = delta, .zeta = zeta};
}

BOOST_AUTO_TEST_CASE(first_returns_have_the_peaks_times_and_speeds_of_small_steps) {
  struct Row {
    double zeta, f, peak, to_peak, back, speed;
  };
  constexpr std::array rows{
      Row{.05, .2, .76345962401663432, 1.3271830320634682, 2.0264924727223612, .45834649609176662},
      Row{.05, .1, .84056563600949248, 1.423503158074547, 1.7709199512783962, .66541222472444988},
      Row{.1, .15, .74803481056817755, 1.3313059016592677, 1.990380787568769, .45182298414076933},
      Row{.2, .05, .72219597828961049, 1.3482110387656789, 1.9180695793288225, .4454031619686496}};
  for (const Row& row : rows) {
    const Response found = free_response(damped(row.zeta, row.f, 0.4), {0, 1});
    BOOST_TEST((found.outcome == Outcome::stopped_at_zero));
    BOOST_TEST(std::abs(found.peak_amplitude - row.peak) <= sixteen_digits);
    BOOST_TEST(std::abs(found.arrival_speed.value() - row.speed) <= sixteen_digits);
    const double tolerance = 4 * sixteen_digits;
    BOOST_TEST(std::abs(found.stop_time.value() - row.to_peak - row.back) <= tolerance);
  }
}

std::vector<HalfCycle> decay(double zeta, double f) {
  return forced_half_cycles(damped(zeta, f, 0), {1, 0}, NoExcitation(), 100, 7, {}, {});
}

BOOST_AUTO_TEST_CASE(a_decay_has_the_series_of_its_closed_form) {
  const std::vector<HalfCycle> turns = decay(.05, .03);
  constexpr std::array peaks{1.,         .798833856, .626943845, .480069350,
                             .354569809, .247334481, .155705336};
  for (std::size_t i = 0; i < peaks.size(); ++i) {
    BOOST_TEST(std::abs(turns.at(i).peak - peaks.at(i)) <= nine_digits);
  }
}

/// X' = E X - (1 + E) phi, twice, gives E and with it zeta, then phi.
BOOST_AUTO_TEST_CASE(damping_and_friction_are_recovered_from_a_decay) {
  for (const double zeta : {.01, .05, .2}) {
    const std::vector<HalfCycle> turns = decay(zeta, .003);
    const double e = (turns.at(1).peak - turns.at(2).peak) / (turns.at(0).peak - turns.at(1).peak);
    const double level = std::log(e) / std::numbers::pi;
    const double phi = (e * turns.at(0).peak - turns.at(1).peak) / (1 + e);
    BOOST_TEST(std::abs(std::abs(level) / std::hypot(1, level) - zeta) <= nine_digits);
    BOOST_TEST(std::abs(phi - .003) <= nine_digits);
  }
}

BOOST_AUTO_TEST_CASE(without_friction_a_damped_motion_never_stops) {
  BOOST_TEST((free_response(damped(.1, 0, 0), {0, 1}).outcome == Outcome::never_stops));
  const Response notched = free_response(damped(.1, 0, 1e-6), {0, 1});
  BOOST_TEST((notched.outcome == Outcome::stopped_at_zero));
}

BOOST_AUTO_TEST_CASE(a_slow_start_against_much_friction_keeps_its_digits) {
  const double v = 1e-7;
  const Response found = free_response(damped(.3, 1, 0), {0, v});
  // L = u^2/2 - 2 zeta u^3/3 of theory with u = v/phi; the next order is below rounding
  const double peak = v * v / 2 - 2 * .3 * v * v * v / 3;
  BOOST_TEST(std::abs(found.peak_amplitude / peak - 1) <= 1e-13);
  BOOST_TEST((found.outcome == Outcome::stopped_in_dead_zone));
  // it takes the integral of 1/(1 + 2 zeta u + u^2)
  BOOST_TEST(std::abs(*found.stop_time / (v - .3 * v * v) - 1) <= 1e-13);
}

/// Backwards from the rest, X = (X' + (1 + E) phi)/E, and each swing takes pi/omega.
BOOST_AUTO_TEST_CASE(a_decay_ends_where_its_closed_form_does) {
  constexpr double phi = 0.01;
  for (const double zeta : {1e-9, .01, .2, .6, .95}) {
    const double swing = pi / std::sqrt((1 - zeta) * (1 + zeta));
    const double e = std::exp(-zeta * swing);
    for (const double rest : {.4 * phi, .9 * phi, -.3 * e * phi}) {  // < 0: after a swing back
      double x = rest;
      for (int i = 0; i < 5; ++i) {
        x = (x + (1 + e) * phi) / e;
      }
      const Response found = free_response(damped(zeta, phi, 0), {x, 0});
      const double tolerance = 32 * sixteen_digits * x;
      BOOST_TEST(std::abs(*found.stop_position - -rest) <= tolerance);
      BOOST_TEST(*found.half_cycles == (rest < 0 ? 5 : 6));
      BOOST_TEST(*found.turning_points == 5);
      BOOST_TEST(std::abs(*found.stop_time / (5 * swing) - 1) <= sixteen_digits);
      BOOST_TEST(found.peak_amplitude == x);
      BOOST_TEST(found.peak_absolute_acceleration == x - phi);
    }
  }
}

/// The map of half-cycles is what the rules make of the motion, piece by piece.
BOOST_AUTO_TEST_CASE(the_map_is_the_motion_piece_by_piece) {
  constexpr std::uint64_t seed = 20267;
  BOOST_TEST_MESSAGE("seed " << seed);
  Dice dice(seed);
  const int scenes = 4 * forced_scene_count();
  int compared = 0;
  for (int i = 0; i < scenes; ++i) {
    const double zeta = dice.once_in(3)   ? dice.power_of_ten(-12, -1)
                        : dice.once_in(2) ? 1 - dice.power_of_ten(-2, -0.1)
                                          : dice.uniform(0.01, 0.99);
    const double v = dice.power_of_ten(-2, 2);
    const double p = dice.power_of_ten(-2, 2);
    const double phi = dice.once_in(7) ? 0 : v * dice.power_of_ten(-2, dice.once_in(9) ? 2 : 0.3);
    const double notch =
        dice.once_in(6) && phi > 0 ? 0 : v * v * dice.power_of_ten(phi > 0 ? -6 : -3, 0.1);
    Oscillator oscillator = damped(std::max(zeta, 1e-12), phi * p, notch / 2, p);
    oscillator.breakaway = dice.once_in(5) ? dice.power_of_ten(0, 1) : 1;
    const double sign = dice.once_in(2) ? -1 : 1;
    const Start start = dice.once_in(4) ? Start{sign * v / p, 0} : Start{0, sign * v};
    const Response found = free_response(oscillator, start);
    const Response slow = forced_response(oscillator, start, NoExcitation(), {}, {});
    const double margin = slow.decision_margin.value_or(1);
    if (margin < 1e-11) {
      BOOST_TEST(found.decision_margin.value() < 2e-11);
      continue;
    }
    ++compared;
    BOOST_TEST_CONTEXT("zeta " << zeta << ", R " << oscillator.breakaway << ", phi/v " << phi / v
                               << ", notch/v^2 " << notch / (v * v) << ", scene " << i) {
      BOOST_TEST((found.outcome == slow.outcome));
      BOOST_TEST((found.half_cycles == slow.half_cycles));
      BOOST_TEST((found.turning_points == slow.turning_points));
      BOOST_TEST((found.zero_passages == slow.zero_passages));
      const auto near = [&](const char* what, double one, double other, double size, double lost) {
        if (!(std::abs(one - other) <= lost * size)) {
          BOOST_ERROR(what << ": " << one << ", by pieces " << other);
        }
      };
      // Pieces lose the time of a short slide, and with a small omega.
      const double rough = (1 + phi / v) / (1 - zeta);
      const double lost = 1e-15 * (2 + *slow.half_cycles) / margin;
      near("peak", found.peak_amplitude, slow.peak_amplitude, slow.peak_amplitude, 1e-14);
      near("acceleration", found.peak_acceleration, slow.peak_acceleration, slow.peak_acceleration,
           1e-14);
      near("felt", found.peak_absolute_acceleration, slow.peak_absolute_acceleration,
           slow.peak_absolute_acceleration, 1e-14);
      near("time", *found.stop_time, *slow.stop_time, *slow.stop_time, lost * rough);
      near("place", *found.stop_position, *slow.stop_position, slow.peak_amplitude, lost);
      near("jump", found.jump, slow.jump, v, lost);
      near("margin", *found.decision_margin, margin, margin, 1e-2);
      BOOST_TEST(found.arrival_speed.has_value() == slow.arrival_speed.has_value());
      near("arrival", found.arrival_speed.value_or(0), slow.arrival_speed.value_or(0), v, lost);
      BOOST_TEST(std::abs(free_peak(oscillator, start) - found.peak_amplitude) == 0);
    }
  }
  BOOST_TEST(compared > scenes / 2);
}

BOOST_AUTO_TEST_CASE(little_damping_is_next_to_none) {
  Dice dice(20264);
  for (int i = 0; i < 200; ++i) {
    const double f = dice.power_of_ten(-2, -0.5);
    const double delta = dice.power_of_ten(-3, -1);
    const Response bare = free_response({1, f, delta}, {0, 1});
    const Response found = free_response(damped(1e-14, f, delta), {0, 1});
    if (*bare.decision_margin < 1e-4) {
      continue;  // there the time of an arrival changes like a square root
    }
    BOOST_TEST((found.outcome == bare.outcome));
    BOOST_TEST(*found.half_cycles == *bare.half_cycles);
    BOOST_TEST(*found.turning_points == *bare.turning_points);
    BOOST_TEST(std::abs(found.peak_amplitude - bare.peak_amplitude) <= 1e-13);
    BOOST_TEST(std::abs(*found.stop_time - *bare.stop_time) <= 1e-10);
    BOOST_TEST(std::abs(found.peak_absolute_acceleration - bare.peak_absolute_acceleration) <=
               1e-12);
  }
}

BOOST_AUTO_TEST_CASE(a_motion_scales_and_mirrors) {
  Dice dice(20265);
  for (int i = 0; i < 200; ++i) {
    const Oscillator one = damped(dice.uniform(0.001, 0.9), dice.power_of_ten(-2, -0.5),
                                  dice.once_in(2) ? 0 : dice.power_of_ten(-3, -1));
    const double p = std::ldexp(1.0, static_cast<int>(dice.below(9)) - 4);
    const Response found = free_response(one, {0, 1});
    const Response mirrored = free_response(one, {0, -1});
    BOOST_TEST(*mirrored.stop_position == -*found.stop_position);
    BOOST_TEST(*mirrored.stop_time == *found.stop_time);
    // x in units of 1/p, so that no rounding differs
    Oscillator other = one;
    other.p = p;
    other.f = one.f * p;
    const Response scaled = free_response(other, {0, 1});
    BOOST_TEST(scaled.peak_amplitude * p == found.peak_amplitude);
    BOOST_TEST(*scaled.stop_time * p == *found.stop_time);
    BOOST_TEST(scaled.peak_absolute_acceleration == found.peak_absolute_acceleration * p);
  }
}

/// By many looks at -x'' = f sgn x' + 2 zeta p x' + p^2 x along the path.
BOOST_AUTO_TEST_CASE(the_structure_feels_the_most_before_the_turn) {
  Dice dice(20266);
  for (int i = 0; i < 50; ++i) {
    const Oscillator oscillator =
        damped(dice.uniform(0.02, 0.8), dice.power_of_ten(-2, -0.7), 0.001);
    const ForcedTrajectory path(oscillator, {0, 1}, NoExcitation(), {.horizon = 12}, {});
    double most = 0;
    for (const State& at : path.sampled(40001)) {
      const double f = at.v > 0 ? oscillator.f : at.v < 0 ? -oscillator.f : 0;
      most = std::max(most, std::abs(f + 2 * oscillator.zeta * at.v + at.x));
    }
    const double found = free_response(oscillator, {0, 1}).peak_absolute_acceleration;
    BOOST_TEST(found >= most * (1 - 1e-14));
    BOOST_TEST(found <= most + 1e-6);
  }
}

/// Published by a public code for its friction element: mass 1, stiffness 1e4, N mu = 1, from
/// 0.85 mm (docs/damping.md section 6): with a breakaway of up to 2, nothing changes.
BOOST_AUTO_TEST_CASE(breakaway_holds_where_friction_alone_would_not) {
  Oscillator oscillator{.p = 100, .f = 1};
  for (const double breakaway : {1., 1.5, 2.}) {
    oscillator.breakaway = breakaway;
    const Response found = free_response(oscillator, {.85e-3, 0});
    BOOST_TEST(std::abs(*found.stop_position - 0.05e-3) <= 1e-17);
    BOOST_TEST(std::abs(*found.stop_time - 4 * std::numbers::pi / 100) <= 1e-15);
  }
  oscillator.breakaway = 2.6;  // holds at the third turn, -0.25 mm
  const Response held = free_response(oscillator, {.85e-3, 0});
  BOOST_TEST(std::abs(*held.stop_position + 0.25e-3) <= 1e-17);
  BOOST_TEST(*held.turning_points == 3);
  oscillator.breakaway = 9;  // at the start
  BOOST_TEST(*free_response(oscillator, {.85e-3, 0}).stop_position == .85e-3);
}

/// A ramp of the load frees the mass at R f, and it leaves under f.
BOOST_AUTO_TEST_CASE(a_mass_leaves_with_what_friction_loses) {
  const Record ramp{{0, 10}, 10, {}};
  Oscillator oscillator{.p = 1, .f = 1};
  oscillator.breakaway = 2;
  const ForcedTrajectory path(oscillator, {0, 0}, ramp, {.horizon = 3}, {});
  constexpr double h = 1e-3;
  BOOST_TEST(path.at(2).x == 0);
  const double expected = -(1 - std::cos(h)) - (h - std::sin(h));  // x'' + x = -(W - f), W = 2 + h
  BOOST_TEST(std::abs(path.at(2 + h).x - expected) <= 1e-15);
}

BOOST_AUTO_TEST_CASE(what_has_no_meaning_is_refused) {
  for (const double zeta : {-0.1, 1.0, 1.5, std::nan("")}) {
    BOOST_CHECK_EXCEPTION((void)free_response(damped(zeta, .1, 0), {0, 1}), InputError,
                          [](const InputError& error) {
                            return std::string(error.what()).find("damping") != std::string::npos;
                          });
  }
  for (const double breakaway : {0.5, 0.0, -1.0, 1e9}) {
    Oscillator oscillator{.p = 1, .f = .1};
    oscillator.breakaway = breakaway;
    BOOST_CHECK_THROW((void)free_response(oscillator, {0, 1}), InputError);
  }
  BOOST_CHECK_THROW((void)first_half_cycles(damped(.1, .1, 0), {0, 1}, 3), InputError);
  BOOST_CHECK_THROW(Trajectory(damped(.1, .1, 0), {0, 1}, {}), InputError);
}

BOOST_AUTO_TEST_SUITE_END()

}  // namespace stillpoint::test
