// SPDX-License-Identifier: MIT
#include "testing/forced_scene.hpp"
#include "testing/integrated_motion.hpp"
#include "testing/scene_count.hpp"

#include <boost/test/unit_test.hpp>

#include <algorithm>
#include <cmath>

// Seeded random scenes of every excitation, against an integrator that shares only the rules with
// the kernel.

namespace stillpoint::test {

BOOST_AUTO_TEST_SUITE(forced_odeint_test)

namespace {

// dopri5 at 1e-13 a step, over some hundreds of steps, and errors that the motion itself enlarges.
constexpr double metric_tolerance = 1e-8;
// What that leaves undecided.
constexpr double decided_margin = 1e-6;

/// Of the scenes that `make` throws with `dice`.
void an_independent_integrator_agrees(Dice dice, ForcedScene<> (*make)(Dice&)) {
  const int count = forced_scene_count();
  int undecided = 0;
  double worst = 0;
  for (int i = 0; i < count; ++i) {
    ForcedScene<> scene = make(dice);
    scene.t_end = std::min(scene.t_end, 25 / scene.motion.p);
    const ForcedState<double> kernel = run_forced(scene).state;
    if (!kernel.margin.any() || kernel.margin.value() < decided_margin) {
      ++undecided;
      continue;
    }
    double size = std::max({kernel.farthest, std::abs(kernel.u), std::abs(kernel.v)});
    size = size > 0 ? size : 1;
    IntegratedMotion other(scene, size / std::max(1.0, scene.motion.p));
    other.run(scene.t_end);
    BOOST_TEST_CONTEXT(scene) {
      const bool rests =
          kernel.mode == ForcedMode::resting && kernel.rest_begin.high() < kernel.now.high();
      BOOST_TEST(other.passages == kernel.passages);
      BOOST_TEST(other.turns == kernel.turning_points);
      BOOST_TEST(std::abs(static_cast<double>(other.sticks - kernel.sticks)) <=
                 (rests || kernel.outcome ? 1 : 0));
      const double off =
          std::max(std::abs(other.x * scene.motion.p - kernel.u), std::abs(other.v - kernel.v)) /
          size;
      BOOST_TEST(off <= metric_tolerance);
      worst = std::max(worst, off);
    }
  }
  BOOST_TEST_MESSAGE(count << " scenes, " << undecided << " undecided, worst difference " << worst);
  BOOST_TEST(undecided <= count / 10);
}

}  // namespace

BOOST_AUTO_TEST_CASE(an_independent_integrator_sees_the_same_motion) {
  an_independent_integrator_agrees(Dice(40401), random_forced_scene);
}

BOOST_AUTO_TEST_CASE(an_independent_integrator_sees_the_same_motion_in_real_notches) {
  an_independent_integrator_agrees(Dice(40402), random_notched_scene);
}

BOOST_AUTO_TEST_SUITE_END()

}  // namespace stillpoint::test
