// SPDX-License-Identifier: MIT
#include "motion.hpp"

// Each rule of docs/forced.md section 1 by itself, with inputs for which the answer is simple, and
// each outcome once.

namespace stillpoint::test {

BOOST_AUTO_TEST_SUITE(forced_rules_test)

BOOST_AUTO_TEST_CASE(a_start_too_slow_for_the_notch_is_caught_whatever_w_does) {
  // v0^2 = 1 < 2 delta
  const auto response = run({1, 0, 0.51}, {0, 1}, Harmonic{100, 1}, 10);
  BOOST_TEST(response.outcome == Outcome::caught_at_start);
  BOOST_TEST(*response.half_cycles == 0);
  BOOST_TEST(*response.stop_time == 0);
}

BOOST_AUTO_TEST_CASE(a_start_just_fast_enough_for_the_notch_sets_off_and_pays_nothing) {
  // v0^2 = 1 = 2 delta: up to x = 1, back with v^2 = 1 <= 2 delta.
  const auto response = run({1, 0, 0.5}, {0, 1}, NoExcitation{}, 10);
  BOOST_TEST(response.outcome == Outcome::stopped_at_zero);
  close(response.peak_amplitude, 1);
  close(*response.stop_time, pi);
}

BOOST_AUTO_TEST_CASE(an_arrival_with_v2_above_two_delta_goes_on_with_the_rest) {
  // From rest at x = -1 under W = 0: arrives with v = 1, goes on with v^2 = 1 - 2 * 0.18 = 0.64.
  const auto response = run({1, 0, 0.18}, {-1, 0}, constant(0), pi / 2 + 0.1);
  BOOST_TEST(*response.zero_passages == 1);
  close(*response.arrival_speed, 1);
  close(*response.final_velocity, 0.8 * std::cos(0.1));
}

BOOST_AUTO_TEST_CASE(a_rest_in_the_notch_is_final_whatever_w_does) {
  // W = 1 pushes from x = 0.25, v = 0 back: about -1 with amplitude 1.25, at x = 0 v^2 = 0.5625.
  const auto response = run({1, 0, 0.3}, {0.25, 0}, constant(1), 1e3);
  BOOST_TEST(response.outcome == Outcome::stopped_at_zero);
  close(*response.stop_time, std::acos(0.8));
  BOOST_TEST(*response.end_time == *response.stop_time);
  close(*response.arrival_speed, 0.75);
  BOOST_TEST(response.sticks == 0);
}

BOOST_AUTO_TEST_CASE(without_a_notch_zero_is_only_counted) {
  const auto response = run({1, 0, 0}, {-1, 0}, NoExcitation{}, 1.6);
  BOOST_TEST(*response.zero_passages == 1);
  close(*response.final_velocity, std::sin(1.6));
  close(*response.arrival_speed, 1);
}

BOOST_AUTO_TEST_CASE(a_turn_inside_the_dead_zone_of_the_load_sticks) {
  // W = 1, f = 2, from x0 = 0 with v0 = 3: about -3 with radius hypot(3, 3), turns at x = 3 sqrt 2
  // - 3 = 1.24; there W + x = 2.24 > f: sets off. With v0 = 1: turns at sqrt 10 - 3 = 0.16, sticks.
  const auto goes_on = run({1, 2, 0}, {0, 3}, constant(1), 100);
  BOOST_TEST(*goes_on.turning_points == 2);
  const auto sticks = run({1, 2, 0}, {0, 1}, constant(1), 100);
  BOOST_TEST(*sticks.turning_points == 1);
  BOOST_TEST(sticks.outcome == Outcome::running);  // the record might still release it
  BOOST_TEST(sticks.sticks == 1);
  close(sticks.stick_time, 100 - std::atan2(1, 3));
  close(*sticks.final_position, std::sqrt(10.0) - 3);
}

BOOST_AUTO_TEST_CASE(a_stick_lasts_until_the_load_exceeds_f) {
  // W = 0.2 sin(tau / 2) exceeds 0.1 at tau = pi / 3.
  const auto waits = run({1, 0.1, 0}, {0, 0}, Harmonic{0.2, 0.5}, pi / 3 - 1e-3);
  BOOST_TEST(*waits.half_cycles == 0);
  BOOST_TEST(*waits.final_position == 0);
  const auto leaves = run({1, 0.1, 0}, {0, 0}, Harmonic{0.2, 0.5}, pi / 3 + 1e-3);
  BOOST_TEST(leaves.sticks == 1);
  close(leaves.stick_time, pi / 3);
  // v'' = -W' = -0.1 cos(pi / 6) there: x = -0.1 cos(pi / 6) h^3 / 6 to first order
  BOOST_TEST(*leaves.final_position == -0.1 * std::cos(pi / 6) * 1e-9 / 6, tt::tolerance(1e-3));
}

BOOST_AUTO_TEST_CASE(from_rest_in_the_notch_w_sets_the_mass_free_until_its_return) {
  // W = -1, f = 0.25 from x = 0: about 0.75, turns at 1.5, back about 1.25: turns at 1 and rests
  // there.
  const auto response = run({1, 0.25, 0.4}, {0, 0}, constant(-1), 100);
  BOOST_TEST(response.left_notch_from_rest);
  BOOST_TEST(*response.turning_points == 2);
  close(response.peak_amplitude, 1.5);
  close(*response.final_position, 1);
  BOOST_TEST(!run({1, 0.25, 0.4}, {0, 0}, constant(-0.25), 100).left_notch_from_rest);
}

BOOST_AUTO_TEST_CASE(a_load_that_never_exceeds_f_leaves_the_mass_at_rest_for_ever) {
  const auto response = run({1, 0.2, 0}, {0.1, 0}, Harmonic{0.1, 3}, 50);
  BOOST_TEST(response.outcome == Outcome::stopped_in_dead_zone);
  BOOST_TEST(*response.stop_time == 0);
  BOOST_TEST(*response.stop_position == 0.1);
}

BOOST_AUTO_TEST_CASE(after_a_pulse_the_motion_is_free) {
  // W = 1 for pi, f = 0: x = -(1 - cos tau) comes to -2 with v = 0 as the pulse ends, and swings
  // on.
  const auto response = run({1, 0, 0}, {0, 0}, Rectangle{1, 1}, std::nullopt);
  BOOST_TEST(response.outcome == Outcome::never_stops);
  close(response.peak_amplitude, 2);
  BOOST_TEST(!response.end_time);
  // With f = 1/8 and W = 1.125 the pulse ends at -2 again; then the peaks fall by 0.25 each.
  const auto stops = run({1, 0.125, 0}, {0, 0}, Rectangle{1.125, 1}, std::nullopt);
  BOOST_TEST((stops.outcome == Outcome::stopped_at_zero ||
              stops.outcome == Outcome::stopped_in_dead_zone));
  close(*stops.stop_time, 9 * pi);  // 2 = 8 * 0.25: eight swings end at 0 within rounding
}

BOOST_AUTO_TEST_CASE(with_and_without_t_end_a_pulse_gives_the_same_motion) {
  const Oscillator oscillator{1, 0.02, 0.003};
  const auto open = run(oscillator, {0, 0}, HalfSine{0.5, 5}, std::nullopt);
  const auto until = run(oscillator, {0, 0}, HalfSine{0.5, 5}, 200);
  BOOST_TEST(open.outcome == until.outcome);
  BOOST_TEST(*open.half_cycles == *until.half_cycles);
  BOOST_TEST(*open.turning_points == *until.turning_points);
  close(open.peak_amplitude, until.peak_amplitude);
  close(open.peak_acceleration, until.peak_acceleration);
  BOOST_TEST(std::abs(*open.stop_time - *until.stop_time) <= 1e-13 * *open.stop_time);
}

BOOST_AUTO_TEST_CASE(without_excitation_the_run_is_the_free_motion) {
  for (const Oscillator& oscillator :
       {Oscillator{1, 0.02, 0.02}, Oscillator{2, 0.1, 0}, Oscillator{0.5, 0, 0.03}}) {
    for (const Start& start : {Start{0, 1}, Start{-0.7, 0.4}, Start{0.9, 0}}) {
      const Response free = free_response(oscillator, start);
      const auto forced = run(oscillator, start, NoExcitation{}, 1e4);
      BOOST_TEST(forced.outcome == free.outcome);
      BOOST_TEST(*forced.half_cycles == *free.half_cycles);
      BOOST_TEST(*forced.turning_points == *free.turning_points);
      close(forced.peak_amplitude, free.peak_amplitude);
      close(forced.peak_acceleration, free.peak_acceleration);
      BOOST_TEST(std::abs(*forced.stop_time - *free.stop_time) <= 1e-12 * *free.stop_time);
    }
  }
}

BOOST_AUTO_TEST_CASE(a_swing_that_ends_at_zero_neither_turns_nor_passes_there) {
  // From x0 = 2 f, p = 1: about f to 0, exactly. Constant forces of equal sum do the same.
  for (const double x0 : {1.0, -1.0, 0.5}) {
    const double f = std::abs(x0) / 2;
    for (const double w : {0.0, x0 / 8}) {
      const double with_w = f + std::abs(w);  // W drives towards 0
      const auto response = run({1, with_w, 0}, {x0, 0}, constant(w), 50);
      BOOST_TEST(*response.turning_points == 0);
      BOOST_TEST(*response.zero_passages == 0);
      BOOST_TEST(*response.half_cycles == 1);
      BOOST_TEST(*response.final_position == 0);
    }
  }
}

BOOST_AUTO_TEST_CASE(a_run_can_be_watched_and_ended) {
  ForcedOptions options{.t_end = 1e6, .ask_every = 10};
  double reached = 0;
  options.go_on = [&](double tau) {
    BOOST_TEST(tau >= reached);
    reached = tau;
    return tau < 100;
  };
  const auto response = forced_response({1, 0.05, 0.01}, {0, 0.5}, Harmonic{0.2, 1}, options);
  BOOST_TEST(response.cancelled);
  BOOST_TEST(response.outcome == Outcome::running);
  BOOST_TEST(*response.end_time == reached);
  BOOST_TEST(reached < 150);
}

BOOST_AUTO_TEST_CASE(what_follows_an_excitation_is_the_free_motion_with_its_margin_and_its_limit) {
  // Held at x = 4 by f = 1, Delta = 0.5: x = 4 swings to 0 with v^2 = 8, goes on with 7 and so on.
  const Oscillator oscillator{1, 1, 0.5};
  const Response free = free_response(oscillator, {4, 0});
  const ForcedResponse forced = run(oscillator, {4, 0}, NoExcitation{}, std::nullopt);
  BOOST_TEST(forced.arrival_speed.value() == free.arrival_speed.value());
  BOOST_TEST(*forced.half_cycles == *free.half_cycles);
  BOOST_TEST(forced.decision_margin.value() == free.decision_margin.value());
  // v0^2 = 2 Delta (1 + 1e-6): that start is the nearest decision, |v0^2 - 2 Delta|/(v0^2 + 2
  // Delta).
  const ForcedResponse started =
      run({1, 1e-2, 0.5}, {0, std::sqrt(1 + 1e-6)}, NoExcitation{}, std::nullopt);
  BOOST_TEST(std::abs(started.decision_margin.value() - 0.5e-6) <= 1e-11);

  ForcedOptions options;
  options.half_cycle_limit = 10;  // f and Delta allow 100
  BOOST_CHECK_THROW((void)forced_response({1, 5e-3, 5e-3}, {1, 0}, NoExcitation{}, options),
                    TooManyHalfCycles);
}

BOOST_AUTO_TEST_CASE(a_mass_on_the_edge_of_sticking_at_the_crest_of_the_load_waits) {
  // |W + x| = k - |x0| = f to the last bit at tau = 0, where W is largest: it is released by the
  // next trough, not at once and again and again.
  const ForcedResponse held =
      until(10, {1, 0.045, 0}, {-0.0099999999999999985, 0}, Harmonic{0.055, 1, pi / 2});
  BOOST_TEST(held.end_time.value() == 10);
  BOOST_TEST(held.sticks >= 1);
}

BOOST_AUTO_TEST_CASE(a_stick_that_the_end_of_the_excitation_ends_is_counted) {
  // W = -1 holds x = 1 (no load at all) for pi; then it swings back freely, f = 0.21: peaks 0.58,
  // 0.16 of 1, and rests there.
  const Excitation excitation = Rectangle{-1, 1};
  const ForcedResponse to_the_end = forced_response({1, 0.21, 0}, {1, 0}, excitation);
  const ForcedResponse in_time = until(50, {1, 0.21, 0}, {1, 0}, excitation);
  BOOST_TEST(to_the_end.sticks == 1);
  BOOST_TEST(to_the_end.stick_time == pi, tt::tolerance(1e-13));
  BOOST_TEST(to_the_end.half_cycles.value() == 3);
  BOOST_TEST(in_time.sticks == to_the_end.sticks);
  BOOST_TEST(in_time.half_cycles.value() == to_the_end.half_cycles.value());
}

BOOST_AUTO_TEST_CASE(before_a_record_of_one_sample_the_motion_is_free) {
  Record record;
  record.values = {-0.2};
  record.times = {0.36};
  const ForcedResponse before = until(0.1, {1, 0.1, 0}, {0, 1}, record);
  const ForcedResponse free = until(0.1, {1, 0.1, 0}, {0, 1}, NoExcitation{});
  BOOST_TEST(before.end_time.value() == 0.1);
  BOOST_TEST(before.final_position.value() == free.final_position.value());
}

BOOST_AUTO_TEST_SUITE_END()

}  // namespace stillpoint::test
