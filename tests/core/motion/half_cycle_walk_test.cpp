// SPDX-License-Identifier: MIT
#include "motion.hpp"

namespace stillpoint::test {

BOOST_AUTO_TEST_SUITE(half_cycle_walk_test)

constexpr double length_tolerance = 1e-14;  // relative
constexpr double time_tolerance = 1e-14;    // relative
constexpr double energy_tolerance = 1e-13;  // relative to the energy of the half-cycle

/// With one friction alone the motion is a closed form, and the walk is not.
Scene<> any_scene(Dice& dice) {
  Scene<> scene = any_start_scene(dice);
  if (dice.once_in(3)) {
    const bool constant = dice.once_in(2);
    (constant ? scene.delta : scene.f) = 0;
    (constant ? scene.f : scene.delta) *= dice.power_of_ten(-1.5, 0);
  }
  return scene;
}

std::vector<HalfCycle> rows(const Scene<>& scene, std::int64_t most = 100000) {
  return first_half_cycles(scene.oscillator(), scene.start(), most);
}

/// The half-cycle agrees with itself and with the one before.
void is_consistent(const Scene<>& scene, const std::vector<HalfCycle>& list, std::size_t k) {
  const HalfCycle& now = list[k];
  BOOST_TEST(now.index == static_cast<std::int64_t>(k) + 1);
  BOOST_TEST(now.last == (k + 1 == list.size()));
  BOOST_TEST(now.start_time <= now.peak_time);
  BOOST_TEST(now.peak_time <= now.end_time);
  BOOST_TEST(now.start_time < now.end_time);
  BOOST_TEST(now.arrival_speed.has_value() == (now.end_position == 0));
  // Constant friction takes f per unit of distance: v-^2 = V^2 + p^2 x0^2 - 2 f (2 A - |x0|).
  const double from = k == 0 ? std::abs(scene.x0) : 0;
  const double way = now.peak_time > now.start_time ? 2 * now.peak - from : from;
  if (now.arrival_speed) {
    const double stored = std::pow(now.departure_speed, 2) + std::pow(scene.p * from, 2);
    const double left = stored - 2 * scene.f * way;
    BOOST_TEST(std::abs(std::pow(*now.arrival_speed, 2) - left) <= energy_tolerance * stored);
  }
  if (k == 0) {
    return;
  }
  const HalfCycle& before = list[k - 1];
  BOOST_TEST(now.start_time == before.end_time);
  BOOST_TEST(now.side == -before.side);
  BOOST_TEST(now.departure_speed <= *before.arrival_speed);
  // Where little is taken the difference of the speeds has lost its digits.
  BOOST_TEST(std::abs(*before.impulse - (*before.arrival_speed - now.departure_speed)) <=
             energy_tolerance * *before.arrival_speed);
  const double arrival = std::pow(*before.arrival_speed, 2);
  BOOST_TEST(std::abs(std::pow(now.departure_speed, 2) - (arrival - 2 * scene.delta)) <=
             energy_tolerance * arrival);
  if (k > 1 && scene.f > 0) {
    BOOST_TEST(now.peak < before.peak);
  }
}

void agrees_with_free_response(const Scene<>& scene, const std::vector<HalfCycle>& list) {
  const Response r = response(scene);
  BOOST_TEST(static_cast<double>(list.size()) == *r.half_cycles);
  const auto highest = std::max_element(
      list.begin(), list.end(), [](const auto& a, const auto& b) { return a.peak < b.peak; });
  near("peak", highest->peak, r.peak_amplitude, length_tolerance);
  const HalfCycle& last = list.back();
  near("end_time", last.end_time, *r.stop_time, 1e-13);
  BOOST_TEST(std::abs(last.end_position - *r.stop_position) <= length_tolerance * r.peak_amplitude);
  BOOST_TEST((last.impulse == last.arrival_speed));  // all of it where the mass stops at x = 0
  if (last.arrival_speed) {
    const double energy = std::pow(scene.p * r.peak_amplitude, 2);
    const double difference = std::pow(*last.arrival_speed, 2) - std::pow(*r.arrival_speed, 2);
    BOOST_TEST(std::abs(difference) <= energy_tolerance * energy);
  }
}

BOOST_AUTO_TEST_CASE(random_walks_are_consistent_and_agree_with_free_response) {
  Dice dice(501);
  for (int i = 0; i < 4000; ++i) {
    const Scene<> scene = any_scene(dice);
    BOOST_TEST_CONTEXT("seed 501, scene " << scene) {
      const std::vector<HalfCycle> list = rows(scene);
      for (std::size_t k = 0; k < list.size(); ++k) {
        is_consistent(scene, list, k);
      }
      BOOST_TEST(list.empty() == (end_of(scene).half_cycles == 0));
      if (!list.empty()) {
        agrees_with_free_response(scene, list);
      }
    }
  }
}

BOOST_AUTO_TEST_CASE(next_to_ties_the_walk_agrees_with_free_response) {
  Dice dice(502);
  for (int found = 0; found < 3000;) {
    const Scene<> scene = any_scene(dice);
    if (const auto tie = near_tie(scene, dice); tie && end_of(*tie).half_cycles > 0) {
      ++found;
      BOOST_TEST_CONTEXT("seed 502, scene " << *tie) {
        agrees_with_free_response(*tie, rows(*tie));
      }
    }
  }
}

BOOST_AUTO_TEST_CASE(no_more_half_cycles_are_listed_than_asked_for) {
  BOOST_TEST(rows({0, 2, 1, 0, 0.01}, 7).size() == 7U);
  BOOST_TEST(rows({0, 2, 1, 0, 0.01}, 0).empty());
}

BOOST_AUTO_TEST_CASE(a_motion_without_friction_goes_on) {
  const std::vector<HalfCycle> list = rows({0, 3, 2, 0, 0}, 1000);
  BOOST_TEST(list.size() == 1000U);
  near("end_time", list.back().end_time, 1000 * pi / 2, time_tolerance);
  near("peak", list.back().peak, 1.5, length_tolerance);
  BOOST_TEST(!list.back().last);
  // Nothing is lost, not even a last bit.
  Dice dice(503);
  for (int i = 0; i < 100; ++i) {
    Scene<> scene = general_start_scene(dice);
    scene.f = scene.delta = 0;
    const std::vector<HalfCycle> same = rows(scene, 3);
    BOOST_TEST(*same[1].arrival_speed == same[1].departure_speed, "seed 503, scene " << scene);
    BOOST_TEST(same[2].departure_speed == same[1].departure_speed, "seed 503, scene " << scene);
  }
}

BOOST_AUTO_TEST_CASE(where_nothing_moves_there_is_no_half_cycle) {
  BOOST_TEST(rows({0, 1, 1, 0.1, 0.6}).empty());
  BOOST_TEST(rows({0.5, 0, 1, 1, 0}).empty());
  BOOST_TEST(rows({0, 0, 1, 1, 0}).empty());
}

BOOST_AUTO_TEST_SUITE_END()

}  // namespace stillpoint::test
