// SPDX-License-Identifier: MIT
#include "motion.hpp"

namespace stillpoint::test {

BOOST_AUTO_TEST_SUITE(trajectory_test)

/// Of a speed no smaller than any of the motion, and of the horizon.
constexpr double state_tolerance = 1e-10;

Trajectory trajectory(const Scene<>& scene, double horizon) {
  return {scene.oscillator(), scene.start(), {.horizon = horizon}};
}

/// Its states and events are those of a run in pieces, which obeys the law of motion.
void is_the_motion_in_pieces(const Scene<>& scene) {
  const Response r = response(scene);
  const double horizon = *r.stop_time + 1 / scene.p;
  const double speed = std::abs(scene.v0) + scene.p * std::abs(scene.x0) + scene.f / scene.p;
  const Trajectory path = trajectory(scene, horizon);
  const ForcedTrajectory pieces(scene.oscillator(), scene.start(), NoExcitation(), {horizon});
  const auto same = [&](const State& one, const State& other) {
    BOOST_TEST(std::abs(one.x - other.x) <= state_tolerance * speed / scene.p);
    BOOST_TEST(std::abs(one.v - other.v) <= state_tolerance * speed);
  };
  for (const Event& event : path.events()) {
    const auto like_it = std::ranges::find_if(pieces.events(), [&](const Event& other) {
      return other.kind == event.kind &&
             std::abs(other.state.tau - event.state.tau) <= state_tolerance * horizon;
    });
    BOOST_TEST_REQUIRE((like_it != pieces.events().end()), name(event.kind));
    same(event.state, like_it->state);
  }
  for (const EventKind kind : {EventKind::arrival, EventKind::passage}) {
    BOOST_TEST(std::ranges::count(path.events(), kind, &Event::kind) ==
               std::ranges::count(pieces.events(), kind, &Event::kind));
  }
  for (const HalfCycle& now : first_half_cycles(scene.oscillator(), scene.start(), 100'000)) {
    for (const auto& [tau, x] : {std::pair(now.peak_time, now.side * now.peak),
                                 std::pair(now.end_time, now.end_position)}) {
      BOOST_TEST(std::ranges::any_of(path.events(), [&, tau = tau, x = x](const Event& event) {
        return std::abs(event.state.tau - tau) <= 1e-14 * horizon &&
               std::abs(event.state.x - x) <= 1e-14 * r.peak_amplitude;
      }));
    }
  }
  for (int i = 0; i < 50; ++i) {
    same(path.at(horizon * i / 50), pieces.at(horizon * i / 50));
  }
  BOOST_TEST(path.at(horizon).v == 0);
  BOOST_TEST(std::abs(path.at(horizon).x - *r.stop_position) <= 1e-11 * r.peak_amplitude);
  // Without a horizon it ends with the motion, and a horizon may cut it anywhere.
  const Trajectory whole(scene.oscillator(), scene.start(), {});
  near("horizon", whole.horizon(), *r.stop_time, 1e-14);
  BOOST_TEST((r.half_cycles == 0.0 || whole.events().back().kind == EventKind::rest));
  BOOST_TEST(whole.events().back().state.tau == whole.horizon());
  for (const double part : {0.01, 0.37, 0.9}) {
    const Trajectory cut = trajectory(scene, part * horizon);
    BOOST_TEST(cut.at(part * horizon).x == path.at(part * horizon).x);
    BOOST_TEST(cut.at(part * horizon / 3).x == path.at(part * horizon / 3).x);
    BOOST_TEST(cut.events().back().state.tau <= part * horizon);
  }
}

BOOST_AUTO_TEST_CASE(the_events_of_a_motion_come_in_order) {
  // f = 7, V0 = 24, Delta = 20: up to 18, back with 72, on with 32, rests at -2.
  const Trajectory path = trajectory({0, 24, 1, 7, 20}, 10);
  const double up = std::atan2(24.0, 7.0);
  const double zero = up + pi / 2 + std::atan2(7.0, std::sqrt(72.0));
  const double end = zero + std::atan2(std::sqrt(32.0), 7.0);
  const auto expected = std::to_array<Event>({{EventKind::start, {0, 0, 24}},
                                              {EventKind::turn, {up, 18, 0}},
                                              {EventKind::arrival, {zero, 0, -std::sqrt(72.0)}},
                                              {EventKind::passage, {zero, 0, -std::sqrt(32.0)}},
                                              {EventKind::rest, {end, -2, 0}}});
  BOOST_REQUIRE(path.events().size() == expected.size());
  for (std::size_t i = 0; i < expected.size(); ++i) {
    const Event& event = path.events()[i];
    BOOST_TEST(name(event.kind) == name(expected[i].kind));
    near("tau", event.state.tau, expected[i].state.tau, 1e-14);
    near("x", event.state.x, expected[i].state.x, 1e-14);
    near("v", event.state.v, expected[i].state.v, 1e-14);
  }
}

BOOST_AUTO_TEST_CASE(a_trajectory_may_end_just_at_a_passage) {
  const Scene<> scene{0, 24, 1, 7, 20};
  const Event passage = trajectory(scene, 10).events().at(3);
  const Trajectory path(scene.oscillator(), scene.start(),
                        {.horizon = passage.state.tau, .half_cycles = 1});
  BOOST_TEST(name(path.events().back().kind) == name(EventKind::passage));
  const State last = path.at(path.horizon());
  BOOST_TEST(last.x == 0);
  BOOST_TEST(last.v == passage.state.v);
}

BOOST_AUTO_TEST_CASE(random_trajectories_are_those_of_a_run_in_pieces) {
  Dice dice(601);
  for (int i = 0; i < 400; ++i) {
    const Scene<> scene = any_start_scene(dice);
    BOOST_TEST_CONTEXT("seed 601, scene " << scene) {
      is_the_motion_in_pieces(scene);
    }
  }
}

BOOST_AUTO_TEST_CASE(overwhelming_friction_leaves_the_states_their_digits) {
  // f = 1e8: x = V0 tau - f tau^2 / 2 but for terms of p^2, until tau = V0 / f; the peak is 5e-9.
  const Trajectory path = trajectory({0, 1, 1, 1e8, 0.125}, 2e-8);
  for (const double part : {0.1, 0.25, 0.5, 0.75, 0.9}) {
    const double tau = part * 1e-8;
    const State state = path.at(tau);
    near("x", state.x, 5e-9 * part * (2 - part), 1e-9);
    near("v", state.v, 1 - part, 1e-9);
  }
  // From x = 0.7 inwards x' = -1e-3 + 1e8 tau: at rest after 1e-11, 5e-15 from the start.
  const State inwards = trajectory({0.7, -1e-3, 1, 1e8, 0.125}, 2e-11).at(0.5e-11);
  near("x", inwards.x, 0.7 - 3.75e-15, 1e-15);
  near("v", inwards.v, -5e-4, 1e-7);
}

BOOST_AUTO_TEST_CASE(where_nothing_moves_the_state_stays) {
  for (const Scene<>& scene : {Scene<>{0, 1, 1, 0.1, 0.6}, {0.5, 0, 1, 1, 0}, {0, 0, 1, 1, 0}}) {
    const Trajectory path = trajectory(scene, 3);
    for (const double tau : {0.0, 1.0, 3.0}) {
      BOOST_TEST(path.at(tau).x == scene.x0);
      BOOST_TEST(path.at(tau).v == 0);
    }
    const Trajectory endless(scene.oscillator(), scene.start(), {});
    BOOST_TEST(endless.horizon() == 0);
    BOOST_TEST(endless.sampled(10).size() == 1U);
  }
}

BOOST_AUTO_TEST_CASE(a_motion_that_never_stops_is_followed_to_the_horizon) {
  const Trajectory path = trajectory({0.3, 2, 2, 0, 0}, 100);
  for (const double tau : {0.0, 0.7, 33.3, 99.9, 100.0}) {
    const State state = path.at(tau);
    BOOST_TEST(std::abs(state.x - (0.3 * std::cos(2 * tau) + std::sin(2 * tau))) <= 1e-12);
    BOOST_TEST(std::abs(state.v - (2 * std::cos(2 * tau) - 0.6 * std::sin(2 * tau))) <= 1e-12);
  }
  BOOST_TEST(path.events().back().state.tau <= 100);
  BOOST_TEST(path.events().back().state.tau > 98);
}

BOOST_AUTO_TEST_CASE(samples_hold_every_event_and_both_ends_in_order) {
  const Trajectory path = trajectory({-1.1, 3, 1.3, 0.2, 0.4}, 20);
  const std::vector<State> states = path.sampled(50);
  BOOST_TEST(states.front().tau == 0);
  BOOST_TEST(states.back().tau == 20);
  BOOST_TEST(std::ranges::is_sorted(states, {}, &State::tau));
  for (const Event& event : path.events()) {
    BOOST_TEST(std::ranges::any_of(states, [&](const State& state) {
      return state.tau == event.state.tau && state.x == event.state.x && state.v == event.state.v;
    }));
  }
  // An event at an instant replaces it: the start replaces the first.
  BOOST_TEST(states.size() == path.events().size() + 49);
  for (int i = 0; i < 50; ++i) {  // and every evenly spaced instant
    BOOST_TEST(std::ranges::any_of(
        states, [&](const State& state) { return std::abs(state.tau - i * 20.0 / 49) <= 1e-14; }));
  }
}

BOOST_AUTO_TEST_SUITE_END()

}  // namespace stillpoint::test
