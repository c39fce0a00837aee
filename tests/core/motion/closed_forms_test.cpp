// SPDX-License-Identifier: MIT
#include "motion.hpp"

// Motions with only one friction take constant time: otherwise the large counts below would never
// return.

namespace stillpoint::test {

BOOST_AUTO_TEST_SUITE(closed_forms_test)

namespace {

constexpr auto at_zero = Outcome::stopped_at_zero;
constexpr auto in_dead_zone = Outcome::stopped_in_dead_zone;

constexpr double time_tolerance = 1e-15;  // relative
// Against the walk, which adds up a time for every half-cycle but counts like the closed form.
constexpr double walk_time_tolerance = 1e-13;    // relative
constexpr double walk_length_tolerance = 1e-15;  // of the highest peak
constexpr double walk_energy_tolerance = 1e-15;  // of the energy at the highest peak
constexpr double count_tolerance = 1e-15;        // relative, where counts exceed 2^53

void agrees_with_the_walk(const Scene<>& scene) {
  BOOST_TEST_CONTEXT("scene " << scene) {
    const Response r = response(scene);
    const std::vector<HalfCycle> list =
        first_half_cycles(scene.oscillator(), scene.start(), 100000);
    BOOST_TEST(*r.half_cycles == static_cast<double>(list.size()));
    const HalfCycle& last = list.back();
    BOOST_TEST(last.last);
    near("stop_time", *r.stop_time, last.end_time, walk_time_tolerance);
    BOOST_TEST(std::abs(*r.stop_position - last.end_position) <=
               walk_length_tolerance * r.peak_amplitude);
    if (last.arrival_speed) {
      const double energy = std::pow(scene.p * r.peak_amplitude, 2);
      const double difference = std::pow(*r.arrival_speed, 2) - std::pow(*last.arrival_speed, 2);
      BOOST_TEST(std::abs(difference) <= walk_energy_tolerance * energy);
    }
  }
}

}  // namespace

BOOST_AUTO_TEST_CASE(point_friction_alone_counts_and_times_half_turns) {
  // v_k^2 = 1 - 0.2 (k - 1) is positive for k up to 5 (the double 0.1 is above the decimal).
  const Response r = response({0, 1, 4, 0, 0.1});
  ends(r, {at_zero, 5, 5, 4});
  near("stop_time", *r.stop_time, 5 * pi / 4, time_tolerance);
  near("peak_amplitude", r.peak_amplitude, 0.25, time_tolerance);
}

BOOST_AUTO_TEST_CASE(constant_friction_alone_counts_half_swings) {
  // S = 101, 2f = 40, S/(2f) = 2.525: two half-swings after the first peak, 81 - 2 * 40 = 1.
  const Response r = response({0, 99, 1, 20, 0});
  ends(r, {in_dead_zone, 3, 3, 2});
  near("stop_time", *r.stop_time, std::atan2(99.0, 20.0) + 2 * pi, time_tolerance);
  BOOST_TEST(*r.stop_position == 1);
}

BOOST_AUTO_TEST_CASE(the_closed_forms_agree_with_the_walk_next_to_ties) {
  Dice dice(202);
  for (int found = 0; found < 2000;) {
    Scene<> scene = any_start_scene(dice);
    (dice.once_in(2) ? scene.delta : scene.f) = 0;
    if (const std::optional<Scene<>> tie = near_tie(scene, dice);
        tie && end_of(*tie).half_cycles > 0) {
      ++found;
      agrees_with_the_walk(*tie);
    }
  }
}

BOOST_AUTO_TEST_CASE(the_closed_forms_agree_with_the_walk_through_all_half_cycles) {
  Dice dice(201);
  for (int i = 0; i < 2000; ++i) {
    Scene<> scene = any_start_scene(dice);
    const bool constant = dice.once_in(2);
    (constant ? scene.delta : scene.f) = 0;
    (constant ? scene.f : scene.delta) *= dice.power_of_ten(-1.5, 0);
    const Response r = response(scene);
    if (*r.half_cycles > 0) {
      agrees_with_the_walk(scene);
    }
  }
}

BOOST_AUTO_TEST_CASE(a_notch_that_divides_the_energy_exactly_takes_it_all) {
  // V0^2 / (2 Delta) = 4 and 64: the last cycle would have no amplitude, and is not counted.
  ends(response({0, 1, 1, 0, 0.125}), {at_zero, 4, 4, 3});
  ends(response({0, 1, 1, 0, std::nextafter(0.125, 1)}), {at_zero, 4, 4, 3});
  ends(response({0, 1, 1, 0, std::nextafter(0.125, 0)}), {at_zero, 5, 5, 4});
  ends(response({0, -1, 1, 0, 0x1p-7}), {at_zero, 64, 64, 63});
  ends(response({0, -1, 1, 0, std::nextafter(0x1p-7, 0)}), {at_zero, 65, 65, 64});
}

BOOST_AUTO_TEST_CASE(a_notch_that_divides_the_energy_only_in_decimals_is_read_as_its_double) {
  // The doubles 0.1, 0.05 and 0.01 lie above the decimals, that of 1/6 below.
  for (const auto& [delta, half_cycles] :
       {std::pair{0.1, 5.0}, {0.05, 10.0}, {0.01, 50.0}, {1.0 / 6, 4.0}}) {
    ends(response({0, 1, 1, 0, delta}), {at_zero, half_cycles, half_cycles, half_cycles - 1});
  }
}

BOOST_AUTO_TEST_CASE(an_odd_number_of_dead_zones_ends_at_zero_without_speed) {
  // x0 = 10, v0 = 20, f = 5: S^2 = 15^2 + 20^2, S = 25 = 5f; x0 = v0 = 100: S = 145 = 29f.
  ends(response({10, 20, 1, 5, 0}), {at_zero, 2, 2, 1});
  ends(response({10, 20, 1, std::nextafter(5, 0), 0}), {in_dead_zone, 3, 3, 2});
  ends(response({10, 20, 1, std::nextafter(5, 9), 0}), {in_dead_zone, 2, 3, 1});
  ends(response({100, 100, 1, 5, 0}), {at_zero, 14, 14, 13});
}

BOOST_AUTO_TEST_CASE(an_even_number_of_dead_zones_ends_on_the_edge) {
  // x0 = 7, v0 = 16, f = 5: S^2 = 12^2 + 16^2, S = 20 = 4f; x0 = 45, v0 = 120: S = 130 = 26f.
  const Response r = response({7, 16, 1, 5, 0});
  ends(r, {in_dead_zone, 2, 2, 1});
  BOOST_TEST(*r.stop_position == -5);
  ends(response({7, 16, 1, std::nextafter(5, 0), 0}), {in_dead_zone, 2, 3, 1});
  ends(response({7, 16, 1, std::nextafter(5, 9), 0}), {in_dead_zone, 2, 2, 1});
  ends(response({45, 120, 1, 5, 0}), {in_dead_zone, 13, 13, 12});
}

BOOST_AUTO_TEST_CASE(from_rest_the_peaks_are_counted_from_the_start) {
  // x0 = 20, f = 1: 20, 18, ..., 2, then zero without speed; x0 = 3: 3, then 1 on the edge.
  ends(response({20, 0, 1, 1, 0}), {at_zero, 10, 9, 9});
  ends(response({3, 0, 1, 1, 0}), {in_dead_zone, 2, 1, 1});
}

BOOST_AUTO_TEST_CASE(a_million_million_half_cycles_return_at_once) {
  // 2 Delta = 2^-40 divides 1 exactly.
  const Response point = response({0, 1, 1, 0, 0x1p-41});
  ends(point, {at_zero, 0x1p40, 0x1p40, 0x1p40 - 1});
  near("stop_time", *point.stop_time, pi * 0x1p40, time_tolerance);
  BOOST_TEST(*point.arrival_speed == 0x1p-20);
  // 1 / (2f) = 1666666666666.67, so ceil - 1 = 1666666666666 half-swings after the first peak; the
  // last peak is 1 - f - 2f * 1666666666666 = 1e-13 (f = 3e-13 is good to 1e-29 * 3e12).
  const Response constant = response({0, 1, 1, 3e-13, 0});
  ends(constant, {in_dead_zone, 1666666666667.0, 1666666666667.0, 1666666666666.0});
  near("stop_time", *constant.stop_time, pi * 1666666666666.5, time_tolerance);
  near("stop_position", *constant.stop_position, 1e-13, 1e-3);
}

BOOST_AUTO_TEST_CASE(counts_far_beyond_integers_return_at_once) {
  for (const Scene<>& scene : {Scene<>{0, 1, 1, 0, 1e-300}, {0, 1, 1, 1e-300, 0}}) {
    const Response r = response(scene);
    near("half_cycles", *r.half_cycles, 5e299, count_tolerance);
    near("stop_time", *r.stop_time, pi * 5e299, time_tolerance);
  }
}

BOOST_AUTO_TEST_CASE(counts_beyond_1e300_are_refused) {
  for (const Scene<>& scene : {Scene<>{0, 1, 1, 0, 1e-301}, {0, 1, 1, 1e-301, 0}}) {
    BOOST_CHECK_THROW((void)response(scene), TooManyHalfCycles);
  }
}

BOOST_AUTO_TEST_CASE(a_closed_form_needs_no_half_cycle_limit) {
  ends(response({0, 1, 1, 0, 0.125}, {.half_cycle_limit = 1}), {at_zero, 4, 4, 3});
}

BOOST_AUTO_TEST_SUITE_END()

}  // namespace stillpoint::test
