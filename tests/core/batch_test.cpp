// SPDX-License-Identifier: MIT
#define BOOST_TEST_MODULE batch
#include "support/checks.hpp"
#include "support/random_scene.hpp"
#include "support/scene.hpp"

#include <stillpoint/core/batch.hpp>
#include <stillpoint/core/input_error.hpp>

#include <boost/test/unit_test.hpp>

#include <limits>

namespace stillpoint::test {

BOOST_AUTO_TEST_CASE(outcomes_can_be_counted_and_absent_values_are_as_documented) {
  // v0 = p = 1. f = delta = 0 never stops; delta = 1 catches it; f = 0, delta = 0.4 stops at x = 0
  // on the second arrival; f = 1, delta = 0 rests at the peak, sqrt(2) - 1.
  const Eigen::ArrayXd f = (Eigen::ArrayXd(4) << 0, 0, 0, 1).finished();
  const Eigen::ArrayXd delta = (Eigen::ArrayXd(4) << 0, 1, 0.4, 0).finished();
  const BatchResult result = free_batch(1, 1, f, delta, {.times = true});
  BOOST_TEST(name(result.outcome[0]) == "never_stops");
  BOOST_TEST(name(result.outcome[1]) == "caught_at_start");
  BOOST_TEST(name(result.outcome[2]) == "stopped_at_zero");
  BOOST_TEST(name(result.outcome[3]) == "stopped_in_dead_zone");
  BOOST_TEST((result.outcome == Outcome::stopped_at_zero).count() == 1);
  BOOST_TEST(result.half_cycles[0] == std::numeric_limits<double>::infinity());
  BOOST_TEST(result.stop_time[0] == std::numeric_limits<double>::infinity());
  BOOST_TEST(result.stop_position[0] == 0);
  BOOST_TEST(result.half_cycles[1] == 0);
  BOOST_TEST(result.half_cycles[2] == 2);
  near("stop_position", result.stop_position[3], std::sqrt(2.0) - 1, 1e-15);
}

}  // namespace stillpoint::test
