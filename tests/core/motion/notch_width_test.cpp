// SPDX-License-Identifier: MIT
#include "motion.hpp"

// A notch with a width and friction in zones, docs/notches.md rules 2 to 4, with inputs for which
// the answer is simple.

namespace stillpoint::test {

BOOST_AUTO_TEST_SUITE(notch_width_test)

ForcedResponse run(const Oscillator& oscillator, const Surface& surface, const Start& start,
                   const Excitation& excitation = {}, std::optional<double> t_end = {}) {
  return forced_response(oscillator, start, excitation, {.t_end = t_end}, surface);
}

Surface notch(double width) {
  return {width, {}};
}

BOOST_AUTO_TEST_CASE(a_motion_that_friction_hardly_slows_is_refused_at_once) {
  // Within |x| = 0.22 it takes at most 1e-20 of v^2 a half-cycle.
  const Surface zone{{}, {{0.22, 1e-20}}};
  for (const double delta : {0.0, 1e-20}) {
    for (const Excitation& load : {Excitation{}, Excitation{Rectangle{0.5, 1}}}) {
      BOOST_CHECK_THROW((void)run({1, 0.1, delta}, zone, {0, 1}, load), TooManyHalfCycles);
    }
  }
}

BOOST_AUTO_TEST_CASE(the_limit_of_half_cycles_refuses_just_what_exceeds_it) {
  Dice dice(18);
  for (int i = 0; i < 300; ++i) {
    const double small = dice.power_of_ten(-3, -1.5);
    const Oscillator oscillator{1, dice.power_of_ten(-2, 0), dice.once_in(2) ? small * small : 0};
    const Surface zone{dice.once_in(4) ? std::optional(small) : std::nullopt,
                       {{dice.uniform(0.05, 0.5), small}, {0.6, dice.power_of_ten(-3, 0)}}};
    const Start start{dice.uniform(-1, 1), dice.uniform(-1, 1)};
    const auto with_limit = [&](double limit) {
      return forced_response(oscillator, start, Rectangle{0.5, 2}, {.half_cycle_limit = limit},
                             zone);
    };
    const double passages = *with_limit(1e6).zero_passages;
    BOOST_CHECK_NO_THROW((void)with_limit(passages + 1));
    if (passages > 0) {
      BOOST_CHECK_THROW((void)with_limit(passages), TooManyHalfCycles);
    }
  }
}

BOOST_AUTO_TEST_CASE(half_cycles_through_zones_are_those_of_arcs_and_of_the_work_of_each) {
  const auto list = [](const Oscillator& oscillator, const Surface& surface, double x0) {
    return forced_half_cycles(oscillator, {x0, 0}, NoExcitation{}, 10, 2, {}, surface);
  };
  // f = 0.125 beyond |x| = 0.5, 0.375 within: v^2 = 3.25 at 0, 3.25 - 0.625 = 2.625 at -0.5. Then
  // 2.625 + 0.25 + 0.125 = 3 = x^2 + 0.25 x at the peak: x = sqrt(3.015625) - 0.125.
  close(list({1, 0.125, 0}, {{}, {{0.5, 0.375}}}, 2).at(1).peak, std::sqrt(3.015625) - 0.125);
  // Friction 1.5 within |x| < 0.1: v^2 = 0.99 - 0.6 at the other edge, and x^2 + v^2 = 0.4.
  close(list({1, 0, 0.3}, notch(0.2), 1).at(1).peak, std::sqrt(0.4));
  // f = 0 outside of |x| = 1, 1 inside: from x = 2 down to 1 in acos(1/2), v^2 = 3; inside about
  // x = 1, so from its centre: x = 0 after asin(1/sqrt 3).
  const HalfCycle first = list({1, 0, 0}, {{}, {{1, 1}}}, 2).at(0);
  close(first.end_time, std::acos(0.5) + std::asin(1 / std::sqrt(3.0)));
  close(*first.arrival_speed, std::sqrt(2.0));
  // Dirac's notch of Delta = 0.25 between zones, 0.25 within |x| < 0.5 and 0 beyond: v^2 = 0.75 at
  // 0.5, 1 - 0.25 = 0.75 at 0, 0.25 after it.
  const auto dirac = list({1, 0, 0.25}, {{}, {{0.5, 0.25}}}, 1);
  close(*dirac.at(0).arrival_speed, std::sqrt(0.75));
  close(dirac.at(1).departure_speed, 0.5);
}

BOOST_AUTO_TEST_CASE(a_rest_at_the_very_edge_is_held_by_the_side_that_it_would_move_to) {
  // At x = 0.5, friction 0.75 inside and 0.25 outside; the spring pulls inwards with 0.5. W = w:
  // held for -0.25 <= w + 0.5 <= 0.75.
  const Surface zone{{}, {{0.5, 0.75}}};
  const auto moves = [&](double w) {
    const auto response = run({1, 0.25, 0}, zone, {0.5, 0}, constant(w), 0.5);
    return *response.half_cycles == 0 ? 0 : *response.final_position > 0.5 ? 1 : -1;
  };
  constexpr double ulp = 1e-15;
  BOOST_TEST(moves(0.25) == 0);
  BOOST_TEST(moves(0.25 + ulp) == -1);
  BOOST_TEST(moves(-0.75) == 0);
  BOOST_TEST(moves(-0.75 - ulp) == 1);
  // Without a load it stays, and is at rest in the zone inside.
  BOOST_TEST(run({1, 0.25, 0}, zone, {0.5, 0}).outcome == Outcome::stopped_in_dead_zone);
  BOOST_TEST(run({1, 0.25, 0.25}, notch(1), {0.5, 0}).outcome == Outcome::stopped_in_notch);
  // Under a harmonic: W = sin tau lets it go inwards at W = 0.25, the other way round at -0.75.
  close(run({1, 0.25, 0}, zone, {0.5, 0}, Harmonic{1, 1}, 1).stick_time, std::asin(0.25));
  close(run({1, 0.25, 0}, zone, {0.5, 0}, Harmonic{-1, 1}, 1).stick_time, std::asin(0.75));
}

/// The mass slips by about the square of what the load is above friction, far from the next edge.
BOOST_AUTO_TEST_CASE(a_slip_by_next_to_nothing_keeps_its_digits_in_a_wide_zone) {
  constexpr double f = 0.1;
  const Surface wide{{}, {{5, f}}};
  for (const double above : {1e-5, 1e-4, 1e-3, 1e-2}) {
    const double k = f * (1 + above);
    for (const Excitation& load :
         {Excitation{Harmonic{k, 0.7}}, Excitation{Record{{0, k, 0}, 2, {}}}}) {
      const auto peak = [&](const Surface& surface) {
        return run({1, f, 0.01}, surface, {}, load, 4).peak_amplitude;
      };
      BOOST_TEST(peak(wide) > 0);
      BOOST_TEST(peak(wide) == peak({}), tt::tolerance(1e-12));
    }
  }
}

BOOST_AUTO_TEST_CASE(friction_alone_does_not_lock) {
  BOOST_TEST(!run({1, 0.125, 0}, notch(0.2), {0, 0}, Harmonic{0.1, 1}, 20).locked_from);
}

BOOST_AUTO_TEST_CASE(the_finite_notch_tends_to_the_papers_in_first_order) {
  // docs/notches.md (N3): rest at 0.2354 w, stop time + 0.0661 w.
  const Oscillator oscillator{1, 0.26, 0.37};
  const Response paper = free_response(oscillator, {0, 1});
  const double v = *paper.arrival_speed;
  const double rest = 0.5 - v * v / (2 * oscillator.delta);
  const double later = v / oscillator.delta - 1 / (2 * v);
  BOOST_TEST(std::abs(rest - 0.2354) < 5e-5);
  BOOST_TEST(std::abs(later - 0.0661) < 5e-5);
  for (const double w : {1e-3, 1e-4, 1e-5}) {
    const auto built = run(oscillator, notch(w), {0, 1});
    BOOST_TEST(built.outcome == Outcome::stopped_in_notch);
    // The next order, and the rounding of a difference.
    BOOST_TEST(std::abs(*built.stop_position / w - rest) <= w);
    BOOST_TEST(std::abs((*built.stop_time - *paper.stop_time) / w - later) <= w + 1e-14 / w);
  }
}

// Its turn is where friction just holds it, but for rounding.
BOOST_AUTO_TEST_CASE(a_mass_that_turns_at_the_end_of_its_dead_zone_rests_there) {
  Dice dice(19);
  for (int i = 0; i < 3000; ++i) {
    const double p = dice.power_of_ten(-2, 2);
    const double f = dice.power_of_ten(-5, 0);
    const double delta = dice.power_of_ten(-2, 0) * f * f / p / p;
    // Starting in the notch, the mass leaves it without its friction: v0^2 = (p r)^2 + 2 f r.
    const double r = f / p / p;
    const double width = r * dice.uniform(0.1, 1.9);
    const double v0 = std::sqrt(3 * f * r);
    const ForcedResponse motion = run({p, f, delta}, notch(width), {0, v0});
    BOOST_TEST(std::abs(motion.stop_position.value() / r - 1) <= 1e-12,
               "p " << p << ", f " << f << ", delta " << delta << ", width " << width);
  }
}

BOOST_AUTO_TEST_CASE(a_wrong_surface_is_refused) {
  const auto refused = [](const Surface& surface, const char* field, const Oscillator& oscillator) {
    check_refused(field, [&] { require_valid(oscillator, surface); });
  };
  const double nan = std::numeric_limits<double>::quiet_NaN();
  const Oscillator plain{1, 0.1, 0.1};
  for (const double width : {0.0, -1.0, nan, std::numeric_limits<double>::infinity()}) {
    refused(notch(width), "notch-width", plain);
  }
  refused(notch(1), "hold", {1, 0.1, 0.1, 0.3});
  refused({{}, {{0, 1}}}, "friction-zones 1: to", plain);
  refused({{}, {{nan, 1}}}, "friction-zones 1: to", plain);
  refused({{}, {{1, 1}, {1, 2}}}, "friction-zones 2: to", plain);
  refused({{}, {{1, 1}, {0.5, 2}}}, "friction-zones 2: to", plain);
  refused({{}, {{1, 1}, {2, -1}}}, "friction-zones 2: f", plain);
  refused({{}, {{1, nan}}}, "friction-zones 1: f", plain);
}

BOOST_AUTO_TEST_SUITE_END()

}  // namespace stillpoint::test
