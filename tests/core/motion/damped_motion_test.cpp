// SPDX-License-Identifier: MIT
#include "motion.hpp"

#include "kernel/certain_passages.hpp"
#include "kernel/damped_piece.hpp"

// Free motions with damping and with breakaway friction: docs/damping.md.

namespace stillpoint::test {

BOOST_AUTO_TEST_SUITE(damped_motion_test)

constexpr double sixteen_digits = 4e-16;  // of values of about 1

Oscillator damped(double zeta, double f, double delta, double p = 1) {
  return {.p = p, .f = f, .delta = delta, .zeta = zeta};
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

/// Without friction each swing takes pi/omega, however slow the mass is where the notch stops it.
BOOST_AUTO_TEST_CASE(the_weakest_notch_stops_a_mass_after_whole_swings) {
  for (const double zeta : {.01, .05, .9}) {
    const double swing = pi / std::sqrt((1 - zeta) * (1 + zeta));
    for (const double delta : {1e-200, 1e-220, 1e-300}) {
      for (const double v0 : {1.0, -1.0}) {
        const Response found = free_response(damped(zeta, 0, delta), {0, v0});
        BOOST_TEST(found.stops_at_zero);
        BOOST_TEST(!std::signbit(found.stop_position.value()));
        const double swings = *found.stop_time / swing / *found.half_cycles;
        BOOST_TEST(std::abs(swings - 1) <= 8 * sixteen_digits);  // a sum of so many parts
      }
    }
  }
}

BOOST_AUTO_TEST_CASE(a_damped_motion_of_too_many_half_cycles_is_refused_at_once) {
  for (const double little : {1e-10, 1e-300}) {
    for (const double zeta : {1e-10, 1e-300}) {
      for (const Start start : {Start{0, 1}, Start{1, 0}}) {
        const Oscillator oscillator = damped(zeta, little, little);
        check_contains(
            refusal_of<TooManyHalfCycles>([&] { (void)free_response(oscillator, start); }),
            {"takes at least", "half-cycle-limit"});
        check_contains(refusal_of<TooManyHalfCycles>([&] {
                         (void)forced_response(oscillator, start, Rectangle{0.5, 1}, {}, {});
                       }),
                       {"takes at least", "half-cycle-limit"});
      }
    }
  }
}

/// (D20) with ends that friction, the notch or damping bring about.
BOOST_AUTO_TEST_CASE(what_is_refused_at_once_would_have_been_refused) {
  Dice dice(20);
  int many = 0;
  for (int i = 0; i < 300; ++i) {
    const double phi = dice.power_of_ten(-6, -3);
    const double notch = dice.once_in(3) ? 0 : dice.power_of_ten(-9, -4);
    Oscillator oscillator = damped(dice.power_of_ten(-7, -3), phi, notch / 2);
    oscillator.breakaway = dice.once_in(5) ? dice.power_of_ten(0, 2) : 1;
    const double passages = *free_response(oscillator, {1, 0}).zero_passages;
    const double certain = certain_passages(1, oscillator.breakaway * phi, notch, oscillator.zeta,
                                            0, [&](double u) { return 4 * phi * u; });
    BOOST_TEST(certain <= passages);
    const auto with_limit = [&](double limit) {
      return free_response(oscillator, {1, 0}, {.half_cycle_limit = limit});
    };
    BOOST_CHECK_NO_THROW((void)with_limit(passages + 1));
    BOOST_CHECK_THROW((void)with_limit(passages), TooManyHalfCycles);
    if (passages > 1000) {
      ++many;
      BOOST_TEST(certain > 0.5 * passages);
    }
  }
  BOOST_TEST(many > 100);
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

/// The map of half-cycles, damped or not, is what the rules make of the motion, piece by piece.
BOOST_AUTO_TEST_CASE(the_map_is_the_motion_piece_by_piece) {
  constexpr std::uint64_t seed = 20267;
  BOOST_TEST_MESSAGE("seed " << seed);
  Dice dice(seed);
  const int scenes = 4 * forced_scene_count();
  int compared = 0;
  for (int i = 0; i < scenes; ++i) {
    const double zeta = dice.once_in(6)   ? 0
                        : dice.once_in(3) ? dice.power_of_ten(-12, -1)
                        : dice.once_in(2) ? 1 - dice.power_of_ten(-2, -0.1)
                                          : dice.uniform(0.01, 0.99);
    const double v = dice.power_of_ten(-2, 2);
    const double p = dice.power_of_ten(-2, 2);
    const double phi = dice.once_in(7) ? 0 : v * dice.power_of_ten(-2, dice.once_in(9) ? 2 : 0.3);
    const double notch =
        dice.once_in(6) && phi > 0 ? 0 : v * v * dice.power_of_ten(phi > 0 ? -6 : -3, 0.1);
    Oscillator oscillator = damped(zeta, phi * p, notch / 2, p);
    oscillator.breakaway = dice.once_in(5) ? dice.power_of_ten(0, 1) : 1;
    const double sign = dice.once_in(2) ? -1 : 1;
    const Start start = dice.once_in(4) ? Start{sign * v / p, 0} : Start{0, sign * v};
    const Response found = free_response(oscillator, start);
    // Without damping it runs in pieces only up to an end that is asked for.
    const auto end = zeta == 0 ? std::optional(found.stop_time.value() + 1 / p) : std::nullopt;
    const ForcedResponse slow =
        forced_response(oscillator, start, NoExcitation(), {.t_end = end}, {});
    BOOST_TEST((!slow.locked_from && !slow.largest_load_while_locked));
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
      if (zeta > 0) {  // decision_margin_test has those without damping
        near("margin", *found.decision_margin, margin, margin, 1e-2);
      }
      BOOST_TEST(found.arrival_speed.has_value() == slow.arrival_speed.has_value());
      near("arrival", found.arrival_speed.value_or(0), slow.arrival_speed.value_or(0), v, lost);
      BOOST_TEST(std::abs(free_peak(oscillator, start) - found.peak_amplitude) == 0);
    }
  }
  BOOST_TEST(compared > scenes / 2);
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

BOOST_AUTO_TEST_CASE(what_has_no_meaning_is_refused) {
  for (const double zeta : {-0.1, 1.0, 1.5, std::nan("")}) {
    check_refused("damping", [&] { (void)free_response(damped(zeta, .1, 0), {0, 1}); });
  }
  for (const double breakaway : {0.5, 0.0, -1.0, 1e9}) {
    Oscillator oscillator{.p = 1, .f = .1};
    oscillator.breakaway = breakaway;
    check_refused("breakaway", [&] { (void)free_response(oscillator, {0, 1}); });
  }
  BOOST_CHECK_THROW((void)first_half_cycles(damped(.1, .1, 0), {0, 1}, 3), InputError);
  BOOST_CHECK_THROW(Trajectory(damped(.1, .1, 0), {0, 1}, {}), InputError);
}

BOOST_AUTO_TEST_SUITE_END()

}  // namespace stillpoint::test
