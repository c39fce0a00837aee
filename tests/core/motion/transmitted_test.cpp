// SPDX-License-Identifier: MIT
#include "motion.hpp"

// What the structure feels, docs/forced.md section 10, along random motions at many instants.
// forced_rules_test has it by hand, practice_test in notches with a width, forced_random_test in 50
// digits.

namespace stillpoint::test {

BOOST_AUTO_TEST_SUITE(transmitted_test)

void check_not_locked(const ForcedResponse& response) {
  BOOST_TEST(!response.locked_from);
  BOOST_TEST(!response.largest_load_while_locked);
}

BOOST_AUTO_TEST_CASE(a_stop_after_the_load_is_not_locked) {
  const ForcedResponse response = run({1, 0.02, 0.05}, {0, 0}, HalfSine{0.5, 5});
  BOOST_TEST(name(response.outcome) == name(Outcome::stopped_at_zero));
  check_not_locked(response);
  close(response.peak_absolute_acceleration, 0.02 + response.peak_amplitude);
  check_not_locked(run({1, 0.02, 0.1}, {0, 0.1}, Harmonic{0, 1}, 9));
  check_not_locked(run({1, 0.02, 0.1}, {0, 0.1}, NoExcitation{}, 9));
}

constexpr std::size_t looks = 8000;

/// The least distance between two places where friction steps.
double finest_zone(const ForcedScene<>& scene) {
  std::vector<double> edges{0, scene.surface.notch_width.value_or(HUGE_VAL) / 2};
  for (const FrictionZone& zone : scene.surface.zones) {
    edges.push_back(zone.to);
  }
  std::ranges::sort(edges);
  double finest = HUGE_VAL;
  for (std::size_t i = 1; i < edges.size(); ++i) {
    finest = std::min(finest, edges[i] - edges[i - 1]);
  }
  return finest;
}

/// With the law of motion at many instants: evenly, at the samples of a record, and next to each
/// event and the end of the load, where W may jump.
std::vector<TracedState> looked_at(const ForcedScene<>& scene) {
  constexpr double close_to_an_end = 1e-9;
  const ForcedTrajectory path(scene.oscillator(), scene.motion.start(), scene.excitation,
                              {scene.t_end}, scene.surface);
  std::vector<double> ends{0, duration(scene.excitation).value_or(scene.t_end), scene.t_end};
  for (const Event& event : path.events()) {
    ends.push_back(event.state.tau);
  }
  std::ranges::sort(ends);
  std::vector<double> more;
  for (std::size_t i = 1; i < ends.size(); ++i) {
    const double beside = close_to_an_end * (ends[i] - ends[i - 1]);
    more.insert(more.end(), {ends[i - 1] + beside, ends[i] - beside});
  }
  if (const auto* record = std::get_if<Record>(&scene.excitation)) {
    for (std::size_t i = 0; i < record->values.size(); ++i) {
      more.push_back(record->times.empty() ? static_cast<double>(i) * record->step
                                           : record->times[i]);
    }
  }
  std::vector<State> states = path.sampled(looks);
  for (const double tau : more) {
    if (tau < scene.t_end) {
      states.push_back(path.at(tau));
    }
  }
  std::ranges::stable_sort(states, {}, &State::tau);
  return traced(scene.oscillator(), scene.surface, scene.excitation, states);
}

/// Random scenes, and among them starts at rest, in the dead zone and in the notch.
ForcedScene<> scene_to_feel(Dice& dice) {
  ForcedScene<> scene = random_forced_scene(dice);
  Scene<>& motion = scene.motion;
  if (dice.once_in(5)) {
    motion.x0 = 0;
    motion.delta = motion.v0 * motion.v0 * dice.uniform(0.4, 2);
  } else if (dice.once_in(4)) {
    motion.v0 = 0;
    motion.f = motion.p * motion.p * std::abs(motion.x0) * dice.uniform(0.4, 1.6);
  }
  return scene;
}

/// Every second scene has real notches, zones, damping or larger friction at rest. What is traced
/// shares no formula with the run.
BOOST_AUTO_TEST_CASE(random_motions_feel_what_the_law_of_motion_says_at_many_instants) {
  constexpr double rounding = 1e-9;  // of the motion, up to a near tie
  constexpr double sampling = 1e-3;  // of a sine between two looks
  Dice dice(1110);
  int locked = 0;
  int loaded = 0;
  int inside = 0;
  const int count = forced_scene_count() / 2;
  for (int i = 0; i < count; ++i) {
    const bool stepped = i % 2 == 1;
    const ForcedScene<> scene = stepped ? random_damped_scene(dice) : scene_to_feel(dice);
    const auto& [p, f, delta, hold, zeta, breakaway] = scene.oscillator();
    const ForcedResponse response =
        run(scene.oscillator(), scene.motion.start(), scene.excitation, scene.t_end, scene.surface);
    if (response.decision_margin.value_or(1) < rounding) {
      continue;
    }
    const double got = response.peak_absolute_acceleration;
    const bool in_notch =
        !stepped &&
        (response.outcome == Outcome::caught_at_start ||
         (response.outcome == Outcome::stopped_at_zero && delta > 0 && *response.half_cycles > 0));
    double fastest = std::abs(scene.motion.v0);  // also of one that the notch catches
    double accelerated = 0;
    double seen = 0;
    double after = 0;
    double off = 0;
    double step = 0;  // of x
    double x = scene.motion.x0;
    for (const TracedState& now : looked_at(scene)) {
      step = std::max(step, std::abs(now.x - x));
      x = now.x;
      const double felt = std::abs(now.absolute_acceleration);
      seen = std::max(seen, felt);
      fastest = std::max(fastest, std::abs(now.v));
      accelerated =
          std::max(accelerated, now.v != 0 ? std::abs(now.absolute_acceleration - now.w) : 0);
      after = std::max(after, in_notch && now.v == 0 && now.tau >= *response.stop_time ? felt : 0);
      off = std::max(off, std::abs(now.absolute_acceleration + now.friction + 2 * zeta * p * now.v +
                                   p * p * now.x));
    }
    BOOST_TEST_CONTEXT("seed 1110, scene " << i << ": " << scene) {
      const double speed = motion_energies(scene.oscillator(), scene.motion.start(),
                                           scene.excitation, {scene.t_end}, scene.surface)
                               .peak_velocity;
      BOOST_TEST(accelerated <= response.peak_acceleration + rounding * got);
      // Where friction steps between two looks, drag and spring change by as much.
      const double between =
          p * (p * step + 2 * zeta * response.peak_acceleration * scene.t_end / looks);
      const bool resolved = finest_zone(scene) > 2 * step;
      BOOST_TEST(
          (!resolved || response.peak_acceleration <= accelerated + sampling * got + between));
      BOOST_TEST(fastest <= speed * (1 + rounding));
      BOOST_TEST(fastest >= speed * (1 - 0.01));
      BOOST_TEST(off <= rounding * (got + response.peak_acceleration));
      BOOST_TEST(got >= seen * (1 - rounding), got << " reported, " << seen << " seen");
      BOOST_TEST((!resolved || got <= seen * (1 + sampling) + between),
                 got << " reported, " << seen << " seen");
      if (!stepped) {
        BOOST_TEST(response.locked_from.has_value() == (after > 0));
        BOOST_TEST((!response.locked_from || response.locked_from == response.stop_time));
        BOOST_TEST(std::abs(response.largest_load_while_locked.value_or(0) - after) <=
                   sampling * after);
      }
    }
    const bool more = got > f + p * p * response.peak_amplitude;
    inside += stepped && scene.surface.notch_width && more ? 1 : 0;
    locked += !stepped && response.locked_from ? 1 : 0;
    loaded += !stepped && more ? 1 : 0;
  }
  BOOST_TEST(locked > count / 40);
  BOOST_TEST(loaded > count / 100);
  BOOST_TEST(inside > count / 80);
}

BOOST_AUTO_TEST_SUITE_END()

}  // namespace stillpoint::test
