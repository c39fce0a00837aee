// SPDX-License-Identifier: MIT
#include "motion.hpp"

// The law of motion without excitation, rule by rule, with numbers chosen so that results come out
// simple. With p = 1: S^2 = V0^2 + f^2, B = S - f (the first peak), v-^2 = B (B - 2f) on return.

namespace stillpoint::test {

BOOST_AUTO_TEST_SUITE(free_rules_test)

namespace {

using std::atan2;
using std::sqrt;

constexpr double length_tolerance = 1e-15;  // relative
constexpr double time_tolerance = 1e-15;    // relative
constexpr double speed_tolerance = 1e-15;   // relative

constexpr auto at_zero = Outcome::stopped_at_zero;
constexpr auto in_dead_zone = Outcome::stopped_in_dead_zone;

void rests(const Response& response, double tau, double x) {
  near("stop_time", response.stop_time.value(), tau, time_tolerance);
  near("stop_position", response.stop_position.value(), x, length_tolerance);
  BOOST_TEST(response.stops_at_zero == (response.outcome == at_zero));
}

void arrives(const Response& response, double speed) {
  near("arrival_speed", response.arrival_speed.value(), speed, speed_tolerance);
}

}  // namespace

// Rule 1. f = 7, V0 = 24: S = 25, B = 18, v-^2 = 18 * 4 = 72; up for atan2(24, 7), down for
// pi/2 + atan2(7, sqrt 72).
const double to_first_return = atan2(24.0, 7.0) + pi / 2 + atan2(7.0, sqrt(72.0));

BOOST_AUTO_TEST_CASE(an_arrival_with_exactly_the_energy_of_the_notch_stops) {
  const Response r = response({0, 24, 1, 7, 36});
  ends(r, {at_zero, 1, 1, 0});
  rests(r, to_first_return, 0);
  peaks(r, 18, 25);
  arrives(r, sqrt(72.0));
  BOOST_TEST(r.decision_margin.value() == 0);
}

BOOST_AUTO_TEST_CASE(an_arrival_with_the_least_bit_more_goes_on) {
  // What is left is 2 * 2^-47; B' = v+^2 / (2f) = 2^-47 / 7.
  const Response r = response({0, 24, 1, 7, std::nextafter(36, 0)});
  ends(r, {in_dead_zone, 2, 2, 1});
  rests(r, to_first_return + atan2(0x1p-23, 7.0), -0x1p-47 / 7);
}

BOOST_AUTO_TEST_CASE(an_arrival_below_the_notch_stops) {
  ends(response({0, 24, 1, 7, 50}), {at_zero, 1, 1, 0});
}

BOOST_AUTO_TEST_CASE(a_passage_takes_the_energy_of_the_notch) {
  // v+^2 = 72 - 40 = 32: S' = 9, B' = 2 < f: rests at the second peak, on the other side.
  const Response r = response({0, 24, 1, 7, 20});
  ends(r, {in_dead_zone, 2, 2, 1});
  rests(r, to_first_return + atan2(sqrt(32.0), 7.0), -2);
  peaks(r, 18, 25);
  arrives(r, sqrt(72.0));
}

BOOST_AUTO_TEST_CASE(lengths_and_times_scale_with_p) {
  // p = 2, f = 14: as speeds the motion above; lengths and times are halved, accelerations doubled.
  const Response r = response({0, -24, 2, 14, 20});
  ends(r, {in_dead_zone, 2, 2, 1});
  rests(r, (to_first_return + atan2(sqrt(32.0), 7.0)) / 2, 1);
  peaks(r, 9, 50);
  arrives(r, sqrt(72.0));
}

// Rule 2, at the peaks.
BOOST_AUTO_TEST_CASE(a_peak_inside_the_dead_zone_is_the_end) {
  // f = 3, V0 = 4: S = 5, B = 2 < 3.
  const Response r = response({0, 4, 1, 3, 0.5});
  ends(r, {in_dead_zone, 1, 1, 0});
  rests(r, atan2(4.0, 3.0), 2);
  peaks(r, 2, 5);
  BOOST_TEST(!r.arrival_speed);
}

BOOST_AUTO_TEST_CASE(a_peak_on_the_edge_of_the_dead_zone_is_the_end) {
  // x0 = 3, v0 = 6, f = 5: S^2 = 8^2 + 6^2, S = 10, B = 5 = f.
  const Response r = response({3, 6, 1, 5, 0.5});
  ends(r, {in_dead_zone, 1, 1, 0});
  rests(r, atan2(6.0, 8.0), 5);
  ends(response({3, 6, 1, std::nextafter(5, 0), 0.5}), {in_dead_zone, 1, 2, 0});
}

BOOST_AUTO_TEST_CASE(a_peak_between_one_and_two_dead_zones_swings_back_and_rests) {
  // f = 5, V0 = 12: S = 13, B = 8, 5 < 8 < 10: rests at 2f - B = 2 after another pi.
  for (const double delta : {0.0, 0.5}) {
    const Response r = response({0, 12, 1, 5, delta});
    ends(r, {in_dead_zone, 1, 2, 0});
    rests(r, atan2(12.0, 5.0) + pi, 2);
    peaks(r, 8, 13);
    BOOST_TEST(!r.arrival_speed);
  }
}

BOOST_AUTO_TEST_CASE(a_peak_at_two_dead_zones_arrives_at_zero_without_speed) {
  // x0 = 4, v0 = 12, f = 5: S^2 = 9^2 + 12^2, S = 15 = 3f, B = 10 = 2f.
  for (const double delta : {0.0, 0.5}) {
    const Response r = response({4, 12, 1, 5, delta});
    ends(r, {at_zero, 1, 1, 0});
    rests(r, atan2(12.0, 9.0) + pi, 0);
    peaks(r, 10, 15);
    BOOST_TEST(r.arrival_speed.value() == 0);
    ends(response({4, 12, 1, std::nextafter(5, 9), delta}), {in_dead_zone, 1, 2, 0});
  }
  ends(response({4, 12, 1, std::nextafter(5, 0), 0.5}), {at_zero, 1, 1, 0});
  ends(response({4, 12, 1, std::nextafter(5, 0), 0}), {in_dead_zone, 2, 2, 1});
}

// Rule 3: without a notch, x = 0 is only counted.
BOOST_AUTO_TEST_CASE(constant_friction_alone_passes_zero_without_loss) {
  // A1 = 18, A2 = 18 - 2f = 4 < f.
  const Response r = response({0, 24, 1, 7, 0});
  ends(r, {in_dead_zone, 2, 2, 1});
  rests(r, atan2(24.0, 7.0) + pi, -4);
  peaks(r, 18, 25);
  arrives(r, sqrt(72.0));
}

BOOST_AUTO_TEST_CASE(point_friction_alone_stops_at_zero) {
  // v^2 = 4, 3, 2, 1, and the fourth arrival has exactly the notch.
  const Response r = response({0, 2, 1, 0, 0.5});
  ends(r, {at_zero, 4, 4, 3});
  rests(r, 4 * pi, 0);
  peaks(r, 2, 2);
  arrives(r, 1);
}

BOOST_AUTO_TEST_CASE(no_friction_never_stops) {
  for (const auto& [scene, amplitude, acceleration] : {std::tuple{Scene<>{0, 3, 2, 0, 0}, 1.5, 6.0},
                                                       {Scene<>{3, -4, 1, 0, 0}, 5.0, 5.0},
                                                       {Scene<>{3, 4, 1, 0, 0}, 5.0, 5.0},
                                                       {Scene<>{-5, 0, 1, 0, 0}, 5.0, 5.0}}) {
    const Response r = response(scene);
    BOOST_TEST(r.outcome == Outcome::never_stops);
    peaks(r, amplitude, acceleration);
    BOOST_TEST(!r.stops_at_zero);
    BOOST_TEST((!r.half_cycles && !r.turning_points && !r.zero_passages && !r.stop_time &&
                !r.stop_position && !r.arrival_speed && !r.decision_margin));
  }
}

// Rule 4: the start.
BOOST_AUTO_TEST_CASE(a_start_below_the_notch_is_caught) {
  const Response r = response({0, -1, 2, 0.1, 0.6});
  ends(r, {Outcome::caught_at_start, 0, 0, 0});
  rests(r, 0, 0);
  peaks(r, 0, 0);
  BOOST_TEST(!r.arrival_speed);
  // 1 - 1.2 relative to 2 * 1 + 1.2.
  near("decision_margin", r.decision_margin.value(), 0.2 / 3.2, 1e-15);
}

BOOST_AUTO_TEST_CASE(a_start_with_exactly_the_energy_of_the_notch_starts) {
  const Response r = response({0, 2, 1, 0, 2});
  ends(r, {at_zero, 1, 1, 0});
  rests(r, pi, 0);
  ends(response({0, 2, 1, 0, std::nextafter(2, 3)}), {Outcome::caught_at_start, 0, 0, 0});
}

BOOST_AUTO_TEST_CASE(the_start_pays_nothing) {
  // With the full 24 at x = 0: B = 18, not that of 24^2 - 2 * 36.
  near("peak_amplitude", response({0, 24, 1, 7, 36}).peak_amplitude, 18, length_tolerance);
}

BOOST_AUTO_TEST_CASE(a_start_off_zero_is_not_caught_by_the_notch) {
  // x0 = 8, v0 = 12, f = 1: S = 15, B = 14, v-^2 = 14 * 12 = 168 < 2 * 100.
  const Response r = response({8, 12, 1, 1, 100});
  ends(r, {at_zero, 1, 1, 0});
  peaks(r, 14, 15);
  arrives(r, sqrt(168.0));
}

BOOST_AUTO_TEST_CASE(nothing_moves_at_zero_without_speed) {
  for (const double friction : {0.0, 0.5}) {
    const Response r = response({0, 0, 1, friction, friction});
    ends(r, {at_zero, 0, 0, 0});
    rests(r, 0, 0);
    peaks(r, 0, 0);
    BOOST_TEST(!r.decision_margin);
  }
}

BOOST_AUTO_TEST_CASE(a_start_at_rest_inside_the_dead_zone_stays) {
  for (const double x0 : {0.5, 1.0}) {  // the edge x0 = f belongs to it
    const Response r = response({-x0, 0, 1, 1, 0.5});
    ends(r, {in_dead_zone, 0, 0, 0});
    rests(r, 0, -x0);
    peaks(r, x0, 0);
  }
}

BOOST_AUTO_TEST_CASE(a_start_at_rest_just_outside_the_dead_zone_swings_to_its_other_end) {
  const double ulp = 0x1p-52;
  const Response r = response({1 + ulp, 0, 1, 1, 0.5});
  ends(r, {in_dead_zone, 1, 1, 0});
  rests(r, pi, 1 - ulp);
  peaks(r, 1 + ulp, ulp);
}

BOOST_AUTO_TEST_CASE(a_start_at_rest_further_out_reaches_zero) {
  // x0 = 3, f = 1: about x = 1 with radius 2, so zero after 2 pi/3 with v-^2 = 4 - 1 = 3.
  // Delta = 1: v+^2 = 1, S' = sqrt 2, rests at the peak sqrt 2 - 1 after another pi/4.
  const Response r = response({3, 0, 1, 1, 1});
  ends(r, {in_dead_zone, 2, 1, 1});
  rests(r, 11 * pi / 12, 1 - sqrt(2.0));
  peaks(r, 3, 2);
  arrives(r, sqrt(3.0));
}

BOOST_AUTO_TEST_CASE(a_start_at_rest_two_dead_zones_out_arrives_at_zero_without_speed) {
  for (const double delta : {0.0, 0.5}) {
    const Response r = response({2, 0, 1, 1, delta});  // x = 1 + cos tau
    ends(r, {at_zero, 1, 0, 0});
    rests(r, pi, 0);
    BOOST_TEST(r.arrival_speed.value() == 0);
  }
}

BOOST_AUTO_TEST_SUITE_END()

}  // namespace stillpoint::test
