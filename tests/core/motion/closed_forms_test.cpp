// SPDX-License-Identifier: MIT
#include "motion.hpp"

// Motions with only one friction take constant time: otherwise the large counts below would never
// return.

namespace stillpoint::test {

BOOST_AUTO_TEST_SUITE(closed_forms_test)

constexpr auto at_zero = Outcome::stopped_at_zero;
constexpr auto in_dead_zone = Outcome::stopped_in_dead_zone;

constexpr double time_tolerance = 1e-15;   // relative
constexpr double count_tolerance = 1e-15;  // relative, where counts exceed 2^53

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
