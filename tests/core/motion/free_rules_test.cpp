// SPDX-License-Identifier: MIT
#include "motion.hpp"

// The law of motion without excitation, rule by rule, with numbers chosen so that results come out
// simple. reference_table_test has the ties of each rule, and one ulp to either side of them.

namespace stillpoint::test {

BOOST_AUTO_TEST_SUITE(free_rules_test)

using std::acos;
using std::atan2;
using std::sqrt;

constexpr double tolerance = 1e-15;       // relative
constexpr double time_tolerance = 2e-15;  // relative: some are differences
constexpr auto at_zero = Outcome::stopped_at_zero;
constexpr auto in_dead_zone = Outcome::stopped_in_dead_zone;

struct Motion {
  Scene<> scene;
  End end;
  std::array<double, 4> known;  ///< peak amplitude and acceleration, stop time and position
  std::optional<double> arrival_speed{};
};

std::ostream& operator<<(std::ostream& stream, const Motion& motion) {
  return stream << motion.scene;
}

// With p = 1: S^2 = V0^2 + f^2, B = S - f (the first peak), v-^2 = B (B - 2f) on return. f = 7,
// V0 = 24: S = 25, B = 18, v-^2 = 18 * 4 = 72; up for atan2(24, 7), down for
// pi/2 + atan2(7, sqrt 72).
const double to_first_return = atan2(24.0, 7.0) + pi / 2 + atan2(7.0, sqrt(72.0));
const double to_second_peak = to_first_return + atan2(sqrt(32.0), 7.0);
// Towards x = 0 with f = 1, x0 = 4, v0 = -4 the arc about x = f has the radius 5, and
// v-^2 = 25 - 1 = 24 where cos = -1/5; it begins at atan2(4, 3) past its virtual peak.
const double inward_to_zero = acos(-0.2) - atan2(4.0, 3.0);

const std::vector<Motion> motions{
    // Rule 1, at x = 0. v-^2 = 2 Delta is taken whole; of 72 - 40 = 32 S' = 9, B' = 2 < f is left.
    {{0, 24, 1, 7, 36}, {at_zero, 1, 1, 0}, {18, 25, to_first_return, 0}, sqrt(72.0)},
    {{0, 24, 1, 7, 20}, {in_dead_zone, 2, 2, 1}, {18, 25, to_second_peak, -2}, sqrt(72.0)},
    // As speeds the same motion; with p = 2 lengths and times are halved, accelerations doubled.
    {{0, -24, 2, 14, 20}, {in_dead_zone, 2, 2, 1}, {9, 50, to_second_peak / 2, 1}, sqrt(72.0)},
    // Rule 2, at the peaks. f = 3, V0 = 4: S = 5, B = 2 < 3. f = 5, V0 = 12: S = 13, B = 8 between
    // f and 2 f: rests at 2f - B = 2 after another pi.
    {{0, 4, 1, 3, 0.5}, {in_dead_zone, 1, 1, 0}, {2, 5, atan2(4.0, 3.0), 2}},
    {{0, 12, 1, 5, 0.5}, {in_dead_zone, 1, 2, 0}, {8, 13, atan2(12.0, 5.0) + pi, 2}},
    // Rule 3, one friction alone: A1 = 18, A2 = 18 - 2f = 4 < f; v^2 = 4, 3, 2, 1.
    {{0, 24, 1, 7, 0}, {in_dead_zone, 2, 2, 1}, {18, 25, atan2(24.0, 7.0) + pi, -4}, sqrt(72.0)},
    {{0, 2, 1, 0, 0.5}, {at_zero, 4, 4, 3}, {2, 2, 4 * pi, 0}, 1},
    // Rule 4, the start: caught by the notch, without speed, held by friction.
    {{0, -1, 2, 0.1, 0.6}, {Outcome::caught_at_start, 0, 0, 0}, {0, 0, 0, 0}},
    {{0, 0, 1, 0.5, 0.5}, {at_zero, 0, 0, 0}, {0, 0, 0, 0}},
    {{-0.5, 0, 1, 1, 0.5}, {in_dead_zone, 0, 0, 0}, {0.5, 0, 0, -0.5}},
    // x0 = 3, f = 1: about x = 1 with radius 2, so zero after 2 pi/3 with v-^2 = 4 - 1; Delta = 1:
    // v+^2 = 1, S' = sqrt 2, rests at sqrt 2 - 1 after another pi/4.
    {{3, 0, 1, 1, 1}, {in_dead_zone, 2, 1, 1}, {3, 2, 11 * pi / 12, 1 - sqrt(2.0)}, sqrt(3.0)},
    // Towards x = 0, R^2 = v0^2 + (x0 - f)^2: f = 6, x0 = 2, v0 = -3: R = 5 turns at x = 1.
    {{2, -3, 1, 6, 0.5}, {in_dead_zone, 1, 1, 0}, {2, 5, atan2(3.0, 4.0), 1}},
    {{-4, 4, 1, 1, 12}, {at_zero, 1, 0, 0}, {4, 3, inward_to_zero, 0}, sqrt(24.0)},
    // x0 = f = 6 begins without acceleration and has f at its end: v-^2 = 64 - 36 where sin = 6/8.
    {{6, -8, 1, 6, 14}, {at_zero, 1, 0, 0}, {6, 6, std::asin(0.75), 0}, sqrt(28.0)},
    // Delta = 10.5: v+^2 = 3, S' = 2 = 2f, B' = 1 = f: on the edge of the dead zone.
    {{4, -4, 1, 1, 10.5}, {in_dead_zone, 2, 1, 1}, {4, 3, inward_to_zero + pi / 3, -1}, sqrt(24.0)},
    // f = 0, x0 = 3, v0 = -4: v-^2 = 25 after atan2(3, 4); Delta = 8: 25 - 16 = 9, then 9 < 16.
    {{3, -4, 1, 0, 8}, {at_zero, 2, 1, 1}, {3, 3, atan2(3.0, 4.0) + pi, 0}, 3},
};

BOOST_DATA_TEST_CASE(each_motion_is_the_one_by_hand, data::make(motions), motion) {
  const Response r = response(motion.scene);
  const auto& [amplitude, acceleration, stop_time, stop_position] = motion.known;
  ends(r, motion.end);
  near("stop_time", r.stop_time.value(), stop_time, time_tolerance);
  near("stop_position", r.stop_position.value(), stop_position, tolerance);
  BOOST_TEST(r.stops_at_zero == (r.outcome == at_zero));
  peaks(r, amplitude, acceleration);
  BOOST_TEST(r.arrival_speed.has_value() == motion.arrival_speed.has_value());
  if (r.arrival_speed && motion.arrival_speed) {
    near("arrival_speed", *r.arrival_speed, *motion.arrival_speed, tolerance);
  }
}

BOOST_AUTO_TEST_CASE(no_friction_never_stops) {
  for (const auto& [scene, amplitude, acceleration] : {std::tuple{Scene<>{0, 3, 2, 0, 0}, 1.5, 6.0},
                                                       {Scene<>{3, -4, 1, 0, 0}, 5.0, 5.0},
                                                       {Scene<>{-5, 0, 1, 0, 0}, 5.0, 5.0}}) {
    const Response r = response(scene);
    BOOST_TEST(r.outcome == Outcome::never_stops);
    peaks(r, amplitude, acceleration);
    BOOST_TEST(!r.stops_at_zero);
    BOOST_TEST((!r.half_cycles && !r.turning_points && !r.zero_passages && !r.stop_time &&
                !r.stop_position && !r.arrival_speed && !r.decision_margin));
  }
}

BOOST_AUTO_TEST_CASE(a_mirror_image_differs_in_the_sign_of_the_rest_alone) {
  for (const Motion& motion : motions) {
    const auto& [x0, v0, p, f, delta] = motion.scene;
    Response expected = response(motion.scene);
    expected.stop_position = -expected.stop_position.value();
    BOOST_TEST((response({-x0, -v0, p, f, delta}) == expected), motion);
  }
}

BOOST_AUTO_TEST_SUITE_END()

}  // namespace stillpoint::test
