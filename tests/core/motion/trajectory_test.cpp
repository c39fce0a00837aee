// SPDX-License-Identifier: MIT
#include "motion.hpp"

namespace stillpoint::test {

BOOST_AUTO_TEST_SUITE(trajectory_test)

constexpr double length_tolerance = 1e-13;  // of the peak amplitude
constexpr double slope_tolerance = 1e-7;    // central differences, of the largest slope

Trajectory trajectory(const Scene<>& scene, double horizon) {
  return {scene.oscillator(), scene.start(), {.horizon = horizon}};
}

/// A speed no smaller than any of the motion's.
double speed_scale(const Scene<>& scene) {
  return std::abs(scene.v0) + scene.p * std::abs(scene.x0) + scene.f / scene.p;
}

/// x' = v and v' = -f sgn v - p^2 x at an instant between events, by central differences.
void obeys_the_law(const Scene<>& scene, const Trajectory& path, double tau, double h) {
  const State before = path.at(tau - h);
  const State now = path.at(tau);
  const State after = path.at(tau + h);
  const double scale = speed_scale(scene);
  const double x_slope = (after.x - before.x) / (2 * h);
  BOOST_TEST(std::abs(x_slope - now.v) <= slope_tolerance * scale, x_slope << " and " << now.v);
  const double v_slope = (after.v - before.v) / (2 * h);
  const double law = -std::copysign(scene.f, now.v) - scene.p * scene.p * now.x;
  BOOST_TEST(std::abs(v_slope - law) <= slope_tolerance * scale * scene.p,
             v_slope << " and " << law << " at tau = " << tau);
}

/// On both sides of an event x is continuous, and v unless the event is an arrival or a passage.
void joins_at(const Scene<>& scene, const Trajectory& path, const Event& event) {
  const double h = 1e-9 / scene.p;
  const double scale = speed_scale(scene);
  const State before = path.at(std::max(0.0, event.state.tau - h));
  const State after = path.at(std::min(path.horizon(), event.state.tau + h));
  BOOST_TEST(std::abs(before.x - event.state.x) <= 4e-9 * scale / scene.p);
  BOOST_TEST(std::abs(after.x - event.state.x) <= 4e-9 * scale / scene.p);
  const double bend = 8e-9 * scale;
  if (event.kind == EventKind::turn || event.kind == EventKind::arrival) {
    BOOST_TEST(std::abs(before.v - event.state.v) <= bend);
  }
  if (event.kind == EventKind::turn || event.kind == EventKind::passage) {
    BOOST_TEST(std::abs(after.v - event.state.v) <= bend);
  }
}

void is_a_motion(const Scene<>& scene) {
  const Response r = response(scene);
  const double horizon = *r.stop_time + 1 / scene.p;
  const Trajectory path = trajectory(scene, horizon);
  const std::vector<Event>& events = path.events();
  for (std::size_t i = 0; i < events.size(); ++i) {
    joins_at(scene, path, events[i]);
    const bool moving = i + 1 < events.size();
    if (!moving || events[i + 1].state.tau > events[i].state.tau) {  // else two velocities
      const State own = path.at(events[i].state.tau);
      BOOST_TEST((own.x == events[i].state.x && own.v == events[i].state.v));
    }
    const double end = moving ? events[i + 1].state.tau : horizon;
    const double span = end - events[i].state.tau;
    if (moving && span > 1e-3 / scene.p) {
      const double h = 1e-5 / scene.p;
      for (const double part : {0.05, 0.3, 0.5, 0.7, 0.95}) {
        obeys_the_law(scene, path, events[i].state.tau + part * span, h);
      }
    }
  }
  // Two events coincide at an arrival; the second is a passage or the rest.
  for (std::size_t i = 0; i < events.size(); ++i) {
    if (events[i].kind == EventKind::arrival) {
      BOOST_TEST(events.at(i + 1).state.tau == events[i].state.tau);
      const double taken = std::pow(events[i].state.v, 2) - std::pow(events[i + 1].state.v, 2);
      if (events[i + 1].kind == EventKind::passage) {
        BOOST_TEST(std::abs(taken - 2 * scene.delta) <= 1e-13 * std::pow(events[i].state.v, 2));
      }
    }
  }
  const State rest = path.at(horizon);
  BOOST_TEST(rest.v == 0);
  BOOST_TEST(std::abs(rest.x - *r.stop_position) <= 1e-11 * r.peak_amplitude);
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

BOOST_AUTO_TEST_CASE(random_trajectories_obey_the_law_and_join_at_events) {
  Dice dice(601);
  for (int i = 0; i < 400; ++i) {
    const Scene<> scene = any_start_scene(dice);
    BOOST_TEST_CONTEXT("seed 601, scene " << scene) {
      is_a_motion(scene);
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
