// SPDX-License-Identifier: MIT
#include "motion.hpp"

// Starts towards x = 0: the arc about x = f of radius R, R^2 = v0^2 + (x0 - f)^2 (p = 1).

namespace stillpoint::test {

BOOST_AUTO_TEST_SUITE(inward_start_test)

namespace {

using std::acos;
using std::atan2;
using std::sqrt;

constexpr double length_tolerance = 1e-15;  // relative
constexpr double time_tolerance = 2e-15;    // relative: the hand result is a difference
constexpr double speed_tolerance = 1e-15;   // relative

}  // namespace

BOOST_AUTO_TEST_CASE(it_may_rest_short_of_zero) {
  // f = 6, x0 = 2, v0 = -3: R = 5, turns at 6 - 5 = 1, still on its side and in the dead zone.
  const Response r = response({2, -3, 1, 6, 0.5});
  ends(r, {Outcome::stopped_in_dead_zone, 1, 1, 0});
  near("stop_time", *r.stop_time, atan2(3.0, 4.0), time_tolerance);
  near("stop_position", *r.stop_position, 1, length_tolerance);
  peaks(r, 2, 5);
  BOOST_TEST(!r.arrival_speed);
}

BOOST_AUTO_TEST_CASE(it_may_reach_zero_without_speed) {
  // f = 5, x0 = 2, v0 = -4: R = 5 = f.
  for (const double delta : {0.0, 0.5}) {
    const Response r = response({2, -4, 1, 5, delta});
    ends(r, {Outcome::stopped_at_zero, 1, 0, 0});
    near("stop_time", *r.stop_time, atan2(4.0, 3.0), time_tolerance);
    BOOST_TEST(r.arrival_speed.value() == 0);
    BOOST_TEST(r.stop_position.value() == 0);
    peaks(r, 2, 5);
  }
}

// f = 1, x0 = 4, v0 = -4: R = 5, v-^2 = 25 - 1 = 24 when cos = -1/5; the arc begins at
// atan2(4, 3) past its virtual peak.
const double to_zero = acos(-0.2) - atan2(4.0, 3.0);

BOOST_AUTO_TEST_CASE(it_may_be_stopped_by_the_notch) {
  const Response r = response({-4, 4, 1, 1, 12});
  ends(r, {Outcome::stopped_at_zero, 1, 0, 0});
  near("stop_time", *r.stop_time, to_zero, time_tolerance);
  near("arrival_speed", *r.arrival_speed, sqrt(24.0), speed_tolerance);
  peaks(r, 4, 3);
}

BOOST_AUTO_TEST_CASE(it_may_pass_and_rest_at_the_peak_beyond) {
  // Delta = 10.5: v+^2 = 3, S' = 2 = 2f, B' = 1 = f: on the edge of the dead zone.
  const Response r = response({4, -4, 1, 1, 10.5});
  ends(r, {Outcome::stopped_in_dead_zone, 2, 1, 1});
  near("stop_time", *r.stop_time, to_zero + atan2(sqrt(3.0), 1.0), time_tolerance);
  near("stop_position", *r.stop_position, -1, length_tolerance);
  peaks(r, 4, 3);
}

BOOST_AUTO_TEST_CASE(it_may_rise_higher_beyond_zero_than_it_started) {
  // Without the notch v-^2 = 24: S' = 5, B' = 4 - the start itself. From v0 = -8: v-^2 = 72, and
  // Delta = 4.5 leaves 63: S' = 8, B' = 7 > 4; then 7 * 5 - 9 = 26, S'' = sqrt 27.
  const Response r = response({4, -8, 1, 1, 4.5});
  peaks(r, 7, 8);
  const Response once = response({4, -8, 1, 1, 17.5});  // 72 - 35 = 37; B' = sqrt 38 - 1
  near("peak_amplitude", once.peak_amplitude, sqrt(38.0) - 1, length_tolerance);
}

BOOST_AUTO_TEST_CASE(its_mirror_image_differs_in_the_sign_of_the_rest_alone) {
  for (const Scene<>& scene :
       {Scene<>{2, -3, 1, 6, 0.5}, {4, -4, 1, 1, 10.5}, {3, 0, 1, 1, 1}, {0, 24, 1, 7, 20}}) {
    Scene<> mirrored = scene;
    mirrored.x0 = -scene.x0;
    mirrored.v0 = -scene.v0;
    const Response a = response(scene);
    const Response b = response(mirrored);
    ends(b, as_run(a).end);
    BOOST_TEST(*a.stop_position == -*b.stop_position);
    BOOST_TEST(*a.stop_time == *b.stop_time);
    BOOST_TEST(a.peak_amplitude == b.peak_amplitude);
    BOOST_TEST(a.peak_acceleration == b.peak_acceleration);
    BOOST_TEST(*a.decision_margin == *b.decision_margin);
  }
}

BOOST_AUTO_TEST_CASE(with_point_friction_alone_it_arrives_with_all_its_energy) {
  // f = 0, x0 = 3, v0 = -4: v-^2 = 25 after atan2(3, 4); Delta = 8: 25 - 16 = 9, then 9 < 16.
  const Response r = response({3, -4, 1, 0, 8});
  ends(r, {Outcome::stopped_at_zero, 2, 1, 1});
  near("stop_time", *r.stop_time, atan2(3.0, 4.0) + std::numbers::pi, time_tolerance);
  near("arrival_speed", *r.arrival_speed, 3, speed_tolerance);
  peaks(r, 3, 3);
}

BOOST_AUTO_TEST_SUITE_END()

}  // namespace stillpoint::test
