// SPDX-License-Identifier: MIT
#include "motion.hpp"

// The largest jump of velocity at a notch without a width: by hand, and as the largest impulse of
// the half-cycles, which are computed by themselves.

namespace stillpoint::test {

BOOST_AUTO_TEST_SUITE(jump_test)

/// The impulses of the listed half-cycles may be off by what rounding makes of a small departure
/// speed: their v^2 is off by some ulp of the first.
constexpr double rounding = 1e-7;

double largest_impulse(const std::vector<HalfCycle>& list) {
  double most = 0;
  for (const HalfCycle& now : list) {
    most = std::max(most, now.impulse.value_or(0));
  }
  return most;
}

BOOST_AUTO_TEST_CASE(free_motions_by_hand) {
  // Point friction alone: v^2 at the arrivals is 1, 1 - 2 delta, ..., and the last is a stop.
  const auto jump = [](double delta) { return free_response({1, 0, delta}, {0, 1}).jump; };
  close(jump(0.45), 1 - std::sqrt(0.1));  // sqrt(0.1) at the stop
  close(jump(0.18), std::sqrt(0.28));     // 1, 0.64, 0.28
  // What the notch catches at the start has its v0 to lose.
  BOOST_TEST(free_response({1, 0.1, 1}, {0, -1.25}).jump == 1.25);
  BOOST_TEST(free_response({1, 0.3, 1}, {0.2, 0}).jump == 0);
  BOOST_TEST(free_response({1, 0, 0}, {0, 1}).jump == 0);
}

BOOST_AUTO_TEST_CASE(forced_motions_jump_by_the_largest_impulse_of_their_half_cycles) {
  Dice dice(1202);
  int jumps = 0;
  for (int i = 0; i < forced_scene_count(); ++i) {
    const ForcedScene<> scene = random_notched_scene(dice);
    const Oscillator oscillator{scene.motion.p, scene.motion.f, scene.motion.delta, scene.hold};
    const Start start = scene.motion.start();
    const ForcedResponse response =
        run(oscillator, start, scene.excitation, scene.t_end, scene.surface);
    const auto list = forced_half_cycles(oscillator, start, scene.excitation, scene.t_end, 100'000,
                                         {}, scene.surface);
    const bool caught = start.x0 == 0 && start.v0 != 0 && oscillator.delta > 0 &&
                        !scene.surface.notch_width && holds_at_start(oscillator.delta, start.v0);
    const double expected = std::max(largest_impulse(list), caught ? std::abs(start.v0) : 0);
    BOOST_TEST(std::abs(response.jump - expected) <= rounding * expected,
               "seed 1202, scene " << i << ": " << scene << ": " << response.jump << ", expected "
                                   << expected);
    jumps += response.jump > 0 ? 1 : 0;
    if (scene.surface.notch_width) {
      BOOST_TEST(response.jump == 0);
    }
  }
  BOOST_TEST(jumps > forced_scene_count() / 10);
}

BOOST_AUTO_TEST_CASE(after_a_load_the_free_motion_counts_as_well) {
  // W = -1 for half a period takes the mass from 0 to 2, and leaves it there with v = 0. Free it
  // arrives with v^2 = 4 and goes on with 4 - 2 delta.
  const auto jump = [](double delta) { return run({1, 0, delta}, {}, Rectangle{-1, 1}).jump; };
  close(jump(2), 2);
  close(jump(1.5), 1);
  close(jump(0.875), 1.5 - std::sqrt(0.5));  // 2 to 1.5 to sqrt(0.5), which stops it
}

BOOST_AUTO_TEST_SUITE_END()

}  // namespace stillpoint::test
