// SPDX-License-Identifier: MIT
#include "motion.hpp"

// A notch with a width and friction in zones, docs/notches.md rules 2 to 4, with inputs for which
// the answer is simple.

namespace stillpoint::test {

BOOST_AUTO_TEST_SUITE(notch_width_test)

namespace {

ForcedResponse run(const Oscillator& oscillator, const Surface& surface, const Start& start,
                   const Excitation& excitation = {}, std::optional<double> t_end = {}) {
  return forced_response(oscillator, start, excitation, {.t_end = t_end}, surface);
}

Surface notch(double width) {
  return {width, {}};
}

}  // namespace

BOOST_AUTO_TEST_CASE(the_work_of_each_zone_stops_the_mass) {
  // p = 1, f = 0.125 beyond |x| = 0.5, 0.375 within. From x = 2: v^2 = 4 - 0.25 - 0.25 * 1.5
  // = 3.375 at 0.5, 3.375 + 0.25 - 0.375 = 3.25 at 0, 3.25 - 0.625 = 2.625 at -0.5. Then 2.625 +
  // 0.25 + 0.125 = 3 = x^2 + 0.25 x at the peak: x = sqrt(3.015625) - 0.125.
  const Surface zone{{}, {{0.5, 0.375}}};
  const auto response = run({1, 0.125, 0}, zone, {2, 0}, {}, 4);
  BOOST_TEST(*response.zero_passages == 1);
  close(*response.arrival_speed, std::sqrt(3.25));
  const auto list = forced_half_cycles({1, 0.125, 0}, {2, 0}, NoExcitation{}, 10, 2, {}, zone);
  close(list.at(1).peak, std::sqrt(3.015625) - 0.125);
  // The longest |x''| is at the start of the return: 2 - 0.125.
  close(response.peak_acceleration, 1.875);
}

BOOST_AUTO_TEST_CASE(times_are_those_of_the_arcs) {
  // f = 0 outside of |x| = 1, 1 inside: from x = 2 down to 1 in acos(1/2), v^2 = 3; inside about
  // x = 1, so from its centre: x = 0 after asin(1/sqrt 3).
  const Surface zone{{}, {{1, 1}}};
  const auto list = forced_half_cycles({1, 0, 0}, {2, 0}, NoExcitation{}, 10, 1, {}, zone);
  close(list.at(0).end_time, std::acos(0.5) + std::asin(1 / std::sqrt(3.0)));
  close(*list.at(0).arrival_speed, std::sqrt(2.0));
}

BOOST_AUTO_TEST_CASE(a_start_from_the_notch_leaves_it_freely) {
  // V0 = p = 1, f = 0: up to x = 1 as without a notch, although Delta/w = 50.
  const auto response = run({1, 0, 0.5}, notch(0.01), {0, 1}, {}, 1.6);
  close(response.peak_amplitude, 1);
  // But a turn inside ends that: V0 = 0.004, w/2 = 0.005, and there it is held.
  const auto slow = run({1, 0, 0.5}, notch(0.01), {0, 0.004});
  BOOST_TEST(slow.outcome == Outcome::stopped_in_notch);
  close(*slow.stop_position, 0.004);
  // And so is a start from rest, by f + Delta/w = 0.1 + 0.2.
  BOOST_TEST(*run({1, 0.1, 0.2}, notch(1), {0, 0}, constant(0.3), 10).half_cycles == 0);
  BOOST_TEST(*run({1, 0.1, 0.2}, notch(1), {0, 0}, constant(0.31), 10).half_cycles == 1);
}

BOOST_AUTO_TEST_CASE(the_mass_rests_inside_the_notch_or_goes_through) {
  // From x = 1, f = 0: at w/2 = 0.1 v^2 = 0.99. Inside friction 5 Delta: v^2 falls by 10 Delta d
  // over d less what the spring gives. With Delta = 1: v^2 = 1 - x^2 - 10 (0.1 - x) = 0 at
  // x^2 - 10 x = 0, so at 0 exactly: rests at zero, met with v = 0.
  const auto at_zero = run({1, 0, 1}, notch(0.2), {1, 0});
  BOOST_TEST(std::abs(*at_zero.stop_position) <= 1e-15);
  // Delta = 2: 1 - x^2 - 20 (0.1 - x) = 0: x = 10 - sqrt(99).
  const auto inside = run({1, 0, 2}, notch(0.2), {1, 0});
  BOOST_TEST(inside.outcome == Outcome::stopped_in_notch);
  close(*inside.stop_position, 10 - std::sqrt(99.0));
  BOOST_TEST(!inside.stops_at_zero);
  BOOST_TEST(*inside.zero_passages == 0);
  BOOST_TEST(*inside.turning_points == 1);
  // Beyond x = 0: Delta = 0.75: 1 - x^2 - 7.5 (0.1 - x) = 0: x = 3.75 - sqrt(14.0625 + 0.25).
  const auto beyond = run({1, 0, 0.75}, notch(0.2), {1, 0});
  BOOST_TEST(beyond.outcome == Outcome::stopped_in_notch);
  close(*beyond.stop_position, 3.75 - std::sqrt(14.3125));
  BOOST_TEST(*beyond.zero_passages == 1);
  // Delta = 0.3: through, with v^2 = 0.99 - 0.6 at the other edge.
  const auto through = run({1, 0, 0.3}, notch(0.2), {1, 0}, {}, pi);
  BOOST_TEST(*through.zero_passages == 1);
  BOOST_TEST(through.outcome == Outcome::running);
  const double v2 = *through.final_velocity * *through.final_velocity;
  close(v2 + *through.final_position * *through.final_position, 0.4);
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

BOOST_AUTO_TEST_CASE(an_edge_met_without_speed_is_a_turn_there) {
  // f = 0 within |x| < 1, 0.5 beyond: v0 = 1 comes to x = 1 with v = 0 exactly. The spring pulls it
  // back with 1 > 0, so it swings for ever between 1 and -1.
  const Surface zone{{}, {{1, 0}}};
  const auto swings = run({1, 0.5, 0}, zone, {0, 1}, {}, 20);
  BOOST_TEST(*swings.zero_passages == 6);
  BOOST_TEST(*swings.turning_points == 6);
  close(swings.peak_amplitude, 1);
  // Friction 2 within: from x = 1.5 with f = 0.25 to x = 1 with v = 0, and there it is held, as the
  // spring's 1 < 2. v0^2 = 0.25 - 1.25 + ... : x^2 + 0.5 (1.5 - x) = 2.25 - ... is met by choice of
  // v0: 2.25 + v0^2 - 0.25 = 1, so instead f = 1.25: 2.25 - 1.25 = 1.
  const auto held = run({1, 1.25, 0}, {{}, {{1, 2}}}, {1.5, 0});
  BOOST_TEST(*held.stop_position == 1);
  BOOST_TEST(held.outcome == Outcome::stopped_in_dead_zone);
}

BOOST_AUTO_TEST_CASE(a_motion_that_comes_to_swing_without_friction_never_stops) {
  const Surface ice{{}, {{1, 0}}};
  const auto never = run({1, 0.5, 0}, ice, {0, 0.9});
  BOOST_TEST(never.outcome == Outcome::never_stops);
  BOOST_TEST(!never.half_cycles);
  BOOST_TEST(!never.stop_time);
  close(never.peak_amplitude, 0.9);
  // From beyond it loses energy until it swings within |x| < 1, or rests outside.
  BOOST_TEST(run({1, 0.5, 0}, ice, {0, 1.5}).outcome == Outcome::never_stops);
  BOOST_TEST(run({1, 1.5, 0}, ice, {1.25, 0}).outcome == Outcome::stopped_in_dead_zone);
  // A notch at x = 0 stops it: v_k^2 = 0.81 - 0.2 (k - 1). So it does after a pulse.
  const auto notched = run({1, 0.5, 0.1}, ice, {0, 0.9});
  BOOST_TEST(notched.outcome == Outcome::stopped_at_zero);
  BOOST_TEST(*notched.half_cycles == 5);
  close(*notched.stop_time, 5 * pi);
  BOOST_TEST(run({1, 0.5, 0.1}, ice, {0, 0}, Rectangle{0.6, 1}).outcome ==
             Outcome::stopped_at_zero);
}

BOOST_AUTO_TEST_CASE(zones_of_one_friction_are_no_zones) {
  const Surface zones{{}, {{0.1, 0.02}, {0.3, 0.02}, {5, 0.02}}};
  for (const Start& start : {Start{0, 1}, Start{-0.7, 0.4}, Start{0.9, 0}}) {
    for (const double delta : {0.0, 0.02}) {
      const Oscillator oscillator{1, 0.02, delta};
      const auto with = run(oscillator, zones, start);
      const Response without = free_response(oscillator, start);
      BOOST_TEST(with.outcome == without.outcome);
      BOOST_TEST(*with.half_cycles == *without.half_cycles);
      BOOST_TEST(*with.turning_points == *without.turning_points);
      // Each piece rounds anew.
      BOOST_TEST(std::abs(*with.stop_time - *without.stop_time) <= 1e-12 * *without.stop_time);
      BOOST_TEST(std::abs(*with.stop_position - *without.stop_position) <= 1e-12);
      close(with.peak_amplitude, without.peak_amplitude);
    }
  }
}

BOOST_AUTO_TEST_CASE(a_notch_stands_on_zones) {
  // |x| < 0.2: 0.5; w/2 = 0.1 within it: 0.5 + 1 / 0.2.
  const Surface surface{0.2, {{0.2, 0.5}}};
  BOOST_TEST(*run({1, 0.1, 1}, surface, {0.05, 0}, constant(5.4), 1).half_cycles == 0);
  BOOST_TEST(*run({1, 0.1, 1}, surface, {0.05, 0}, constant(5.5), 1).half_cycles == 1);
  BOOST_TEST(*run({1, 0.1, 1}, surface, {0.15, 0}, constant(0.3), 1).half_cycles == 0);
  BOOST_TEST(*run({1, 0.1, 1}, surface, {0.15, 0}, constant(0.4), 1).half_cycles == 1);
}

BOOST_AUTO_TEST_CASE(dirac_s_notch_stands_between_zones) {
  // Friction 0.25 within |x| < 0.5, 0 beyond, and Delta = 0.25 at x = 0. From x = 1: v^2 = 0.75 at
  // 0.5, 1 - 0.25 = 0.75 at 0, 0.25 after it.
  const Surface zone{{}, {{0.5, 0.25}}};
  const auto list = forced_half_cycles({1, 0, 0.25}, {1, 0}, NoExcitation{}, 10, 2, {}, zone);
  close(*list.at(0).arrival_speed, std::sqrt(0.75));
  close(list.at(1).departure_speed, 0.5);
}

BOOST_AUTO_TEST_CASE(a_zone_without_friction_about_zero_leaves_a_motion_that_never_stops) {
  // Each turn is beyond the edge by about half as much as the one before it: f = p^2 L/4.
  const Surface zone{{}, {{0.1, 0}}};
  BOOST_TEST(run({2, 0.1, 0}, zone, {0, 1}).outcome == Outcome::never_stops);
}

BOOST_AUTO_TEST_CASE(the_structure_feels_the_friction_of_each_zone) {
  // From x = 1 with f = 0.125 and Delta/w = 1 within |x| < 0.1: at the start 0.125 - 1, inside at
  // most 1.125 + 0.1 on the way out, beyond the notch 0.125 + |x|.
  const auto through = run({1, 0.125, 0.2}, notch(0.2), {1, 0}, {}, 5);
  close(through.peak_absolute_acceleration, 1.225);
  // A notch that is left freely, at the start, is not felt: 0.125 + |x| at the peak.
  const auto leaves = run({1, 0.125, 0.2}, notch(0.2), {0, 1}, {}, 1.5);
  close(leaves.peak_absolute_acceleration, 0.125 + leaves.peak_amplitude);
  // From rest it holds f + Delta/w = 1.125, and locks.
  const auto locked = run({1, 0.125, 0.2}, notch(0.2), {0, 0}, Harmonic{1.1, 1}, 20);
  BOOST_TEST(locked.outcome == Outcome::stopped_at_zero);
  BOOST_TEST(locked.locked_from.value() == 0);
  close(locked.peak_absolute_acceleration, 1.1);
  close(locked.largest_load_while_locked.value(), 1.1);
  // Without Delta there is no notch that could hold it, only friction.
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

BOOST_AUTO_TEST_CASE(simulate_gives_all_of_a_motion_with_a_notch) {
  SimulationRequest request;
  request.oscillator = {1, 0.05, 0.1};
  request.surface = notch(0.05);
  request.start = {0, 1};
  request.samples = 100;
  const Simulation answer = simulate(request);
  BOOST_TEST(!answer.forced);
  BOOST_TEST(answer.response.outcome == Outcome::stopped_in_notch);
  BOOST_TEST(static_cast<double>(answer.half_cycles.size()) == *answer.response.half_cycles);
  BOOST_TEST(answer.half_cycles.back().end_position == *answer.response.stop_position);
  BOOST_TEST(answer.trajectory.back().tau == *answer.response.stop_time);
  BOOST_TEST(answer.trajectory.back().x == *answer.response.stop_position);
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
