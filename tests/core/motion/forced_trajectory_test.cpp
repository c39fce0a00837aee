// SPDX-License-Identifier: MIT
#include "motion.hpp"

// The state at any instant: it obeys the equation between events, and agrees with the metrics.

namespace stillpoint::test {

BOOST_AUTO_TEST_SUITE(forced_trajectory_test)

/// x' = v, and v' as the law of motion has it, by differences over 2 h in the middle of each piece.
BOOST_AUTO_TEST_CASE(between_events_the_state_obeys_the_equation_of_motion) {
  constexpr double difference = 1e-6;  // of the largest of the motion
  Dice dice(6);
  int looked_at = 0;
  for (int i = 0; i < 200; ++i) {
    const ForcedScene<> scene = i % 2 == 0 ? random_forced_scene(dice) : random_damped_scene(dice);
    const Oscillator oscillator = scene.oscillator();
    const Start start = scene.motion.start();
    const ForcedTrajectory path(oscillator, start, scene.excitation, {scene.t_end}, scene.surface);
    const double fastest =
        motion_energies(oscillator, start, scene.excitation, {scene.t_end}, scene.surface)
            .peak_velocity;
    const double h = 1e-7 / oscillator.p;
    std::set<double> middles;
    std::vector<State> states = path.sampled(2);
    for (std::size_t k = 0; k + 1 < path.events().size(); ++k) {
      const double from = path.events()[k].state.tau;
      const double to = path.events()[k + 1].state.tau;
      if (to - from >= 10 * h) {
        states.push_back(path.at(*middles.insert(std::lerp(from, to, 0.4)).first));
      }
    }
    std::ranges::stable_sort(states, {}, &State::tau);
    for (const TracedState& now : traced(oscillator, scene.surface, scene.excitation, states)) {
      if (!middles.contains(now.tau) || now.v == 0) {
        continue;
      }
      ++looked_at;
      const State before = path.at(now.tau - h);
      const State after = path.at(now.tau + h);
      const double size = oscillator.p * fastest + std::abs(now.w) + std::abs(now.friction);
      BOOST_TEST_CONTEXT("tau " << now.tau << " of " << scene) {
        BOOST_TEST(std::abs((after.x - before.x) / (2 * h) - now.v) <= difference * fastest);
        BOOST_TEST(std::abs((after.v - before.v) / (2 * h) - (now.absolute_acceleration - now.w)) <=
                   difference * size);
      }
    }
  }
  BOOST_TEST(looked_at > 2000);
}

BOOST_AUTO_TEST_CASE(
    events_are_in_order_on_the_path_whose_largest_x_and_end_are_those_of_the_metrics) {
  Dice dice(5);
  for (int i = 0; i < 50; ++i) {
    const ForcedScene<> scene = random_forced_scene(dice);
    const ForcedTrajectory path(scene.motion.oscillator(), scene.motion.start(), scene.excitation,
                                {scene.t_end});
    double before = 0;
    for (const Event& event : path.events()) {
      BOOST_TEST(event.state.tau >= before);
      before = event.state.tau;
      const State at = path.at(std::min(event.state.tau, path.horizon()));
      BOOST_TEST(std::abs(at.x - event.state.x) <= 1e-9 * std::max(1.0, std::abs(at.x)));
    }
    const auto response = forced_response(scene.motion.oscillator(), scene.motion.start(),
                                          scene.excitation, {.t_end = scene.t_end});
    double most = 0;
    for (const State& state : path.sampled(400)) {
      most = std::max(most, std::abs(state.x));
    }
    BOOST_TEST(most == response.peak_amplitude, tt::tolerance(1e-12));
    BOOST_TEST(std::abs(path.at(scene.t_end).x - *response.final_position) <=
               1e-12 * std::max(1.0, response.peak_amplitude));
  }
}

BOOST_AUTO_TEST_CASE(at_a_passage_the_state_is_that_after_the_notch) {
  for (const double p : {1.0, 1.1, 1.7, 3.1}) {  // p tau rounds, now up, now down
    const ForcedTrajectory path({p, 0.05, 0.01}, {0, 0.5}, Harmonic{0.2, p}, {20});
    for (const Event& event : path.events()) {
      if (event.kind == EventKind::passage) {
        BOOST_TEST(path.at(event.state.tau).v == event.state.v);
      }
    }
  }
}

BOOST_AUTO_TEST_CASE(after_the_final_rest_nothing_moves) {
  for (const double p : {1.0, 1.1, 1.7, 3.1}) {
    const ForcedTrajectory path({p, 0.05, 0.05}, {0, 0.5}, HalfSine{0.2, p}, {40});
    const Event& rest = path.events().back();
    BOOST_TEST_REQUIRE((rest.kind == EventKind::rest));
    for (const double tau : {rest.state.tau, std::nextafter(rest.state.tau, 40.0), 39.0}) {
      BOOST_TEST(path.at(tau).x == rest.state.x);
      BOOST_TEST(path.at(tau).v == 0);
    }
  }
}

BOOST_AUTO_TEST_CASE(before_its_release_the_mass_is_where_it_started) {
  // W = 0.2 sin tau, held at x = 0.05 by f = 0.1 until sin tau = 0.25.
  const ForcedTrajectory path({1, 0.1, 0}, {0.05, 0}, Harmonic{0.2, 1}, {10});
  for (const double tau : {0.0, 0.1, 0.25}) {
    BOOST_TEST(path.at(tau).x == 0.05);
    BOOST_TEST(path.at(tau).v == 0);
  }
}

BOOST_AUTO_TEST_CASE(late_states_keep_their_digits) {
  // W = -(tau - T) from T = 10^8 on sets it off: x = (h - sin(p h) / p) / p^2, h = tau - T. An ulp
  // of p tau, 1.5e-8, is far more than the tolerance.
  constexpr double late = 1e8;
  for (const double p : {1.0, 1.1, 1.7}) {
    const Record ramp{{0, 0, -1, 0}, 1, {0, late, late + 1, late + 2}};
    const ForcedTrajectory path({p, 0, 0}, {0, 0}, ramp, {late + 1});
    for (const double h : {0.25, 0.5, 0.75}) {
      const State now = path.at(late + h);
      BOOST_TEST(now.x == (h - std::sin(p * h) / p) / (p * p), tt::tolerance(1e-13));
      BOOST_TEST(now.v == (1 - std::cos(p * h)) / (p * p), tt::tolerance(1e-13));
    }
  }
}

BOOST_AUTO_TEST_CASE(no_event_is_beyond_the_horizon) {
  int at_the_end = 0;
  for (int i = 0; i < 200; ++i) {  // p tau / p may be an ulp more than tau
    const double p = 0.3 + 0.037 * i;
    const HalfSine pulse{0.2, 0.7 + 0.01 * i};
    const double end = duration(pulse).value();
    const ForcedTrajectory path({p, 0.05, 0.01}, {0, 0.5}, pulse, {end});
    for (const Event& event : path.events()) {
      BOOST_TEST(event.state.tau <= end);
      at_the_end += event.kind == EventKind::excitation_end ? 1 : 0;
    }
  }
  BOOST_TEST(at_the_end == 200);
}

BOOST_AUTO_TEST_CASE(it_ends_where_asked) {
  ForcedTrajectoryOptions limits{.horizon = 1e6};
  int asked = 0;
  limits.go_on = [&asked](double) { return ++asked < 3; };
  const ForcedTrajectory path({1, 0.05, 0.01}, {0, 0.5}, Harmonic{0.2, 1}, limits);
  BOOST_TEST(asked == 3);
  BOOST_TEST(path.events().size() > 100U);
  BOOST_TEST(path.events().size() < 20'000U);
}

BOOST_AUTO_TEST_CASE(outside_the_horizon_and_beyond_the_limit_it_refuses) {
  const ForcedTrajectory path({1, 0.05, 0.01}, {0, 0.5}, Harmonic{0.2, 1}, {20});
  BOOST_CHECK_THROW((void)path.at(-1), InputError);
  BOOST_CHECK_THROW((void)path.at(20.1), InputError);
  BOOST_CHECK_THROW((void)path.sampled(1), InputError);
  BOOST_CHECK_THROW(ForcedTrajectory({1, 0.05, 0}, {0, 0.5}, Harmonic{0.2, 1}, {1e6, 100}),
                    InputError);
}

BOOST_AUTO_TEST_CASE(as_many_pieces_as_allowed_are_not_too_many) {
  // Held for ever: start, stick and rest are one piece each.
  const auto of_pieces = [](std::int64_t most) {
    return ForcedTrajectory({1, 0.3, 0}, {0, 0}, Harmonic{0.2, 1}, {50, most});
  };
  BOOST_TEST(of_pieces(3).events().size() == 3U);
  BOOST_CHECK_THROW(of_pieces(2), InputError);
}

BOOST_AUTO_TEST_CASE(what_never_moves_keeps_its_horizon) {
  for (const Oscillator& oscillator : {Oscillator{1, 0.3, 0}, Oscillator{1, 0.3, 0.6}}) {
    const Start start{0, oscillator.delta > 0 ? 1.0 : 0.0};  // held by friction, by the notch
    const ForcedTrajectory path(oscillator, start, Harmonic{0.2, 1},
                                {.horizon = 50, .to_rest = true});
    BOOST_TEST(path.horizon() == 50);
    BOOST_TEST(path.at(50).v == 0);
  }
}

BOOST_AUTO_TEST_CASE(the_final_rest_under_a_load_is_an_event_of_its_own_instant) {
  const Oscillator oscillator{1, 0.8, 0};
  const Rectangle pulse{0.5, 0.1};
  const double stop = forced_response(oscillator, {0, 1}, pulse).stop_time.value();
  const ForcedTrajectory whole(oscillator, {0, 1}, pulse, {50});
  const auto rest = std::ranges::find(whole.events(), EventKind::rest, &Event::kind);
  BOOST_TEST_REQUIRE((rest != whole.events().end()));
  BOOST_TEST(rest->state.tau == stop);
  BOOST_TEST(whole.events().back().kind == EventKind::excitation_end);
  BOOST_TEST(whole.horizon() == 50);
  BOOST_TEST(whole.at(50).x == rest->state.x);
  // Or it ends there.
  const ForcedTrajectory moving(oscillator, {0, 1}, pulse, {.horizon = 50, .to_rest = true});
  BOOST_TEST(moving.horizon() == stop);
  BOOST_TEST(moving.events().back().kind == EventKind::rest);
  BOOST_TEST(moving.sampled(10).back().tau == stop);
}

BOOST_AUTO_TEST_SUITE_END()

}  // namespace stillpoint::test
