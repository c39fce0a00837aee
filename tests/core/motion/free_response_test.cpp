// SPDX-License-Identifier: MIT
#include "motion.hpp"

// What free_response computes when asked, and free_peak.

namespace stillpoint::test {

BOOST_AUTO_TEST_SUITE(free_response_test)

Scene<> any_scene(Dice& dice) {
  Scene<> scene = any_start_scene(dice);
  if (dice.once_in(4)) {
    scene.f = 0;
  }
  if (dice.once_in(4)) {
    scene.delta = 0;
  }
  return scene;
}

BOOST_AUTO_TEST_CASE(only_what_was_asked_for_is_there_and_the_rest_is_the_same) {
  Dice dice(801);
  for (int i = 0; i < 2000; ++i) {
    const Scene<> scene = any_scene(dice);
    BOOST_TEST_CONTEXT("seed 801, scene " << scene) {
      const Response all = response(scene);
      for (const FreeOptions& options : {FreeOptions{.times = false}, FreeOptions{.margin = false},
                                         FreeOptions{.times = false, .margin = false}}) {
        Response expected = all;
        expected.stop_time = options.times ? all.stop_time : std::nullopt;
        expected.decision_margin = options.margin ? all.decision_margin : std::nullopt;
        BOOST_TEST((response(scene, options) == expected));
      }
    }
  }
}

BOOST_AUTO_TEST_CASE(free_peak_is_the_peak_amplitude_bit_for_bit) {
  Dice dice(802);
  for (int i = 0; i < 20000; ++i) {
    const Scene<> scene = any_scene(dice);
    const double peak = response(scene, {.times = false, .margin = false}).peak_amplitude;
    BOOST_TEST(free_peak(scene.oscillator(), scene.start()) == peak,
               "seed 802, scene " << scene << ": peak_amplitude " << peak << ", free_peak "
                                  << free_peak(scene.oscillator(), scene.start()));
  }
}

BOOST_AUTO_TEST_CASE(the_least_speed_moves_against_friction_far_above_it) {
  // f = 1/2, V0 = 1e-150: the peak V0^2 / (2f) = 1e-300 is about the least that is taken.
  const Response r = response({0, 1e-150, 1, 0.5, 0});
  BOOST_TEST(name(r.outcome) == "stopped_in_dead_zone");
  near("peak_amplitude", r.peak_amplitude, 1e-300, 1e-15);
  near("stop_position", *r.stop_position, 1e-300, 1e-15);
}

BOOST_AUTO_TEST_SUITE_END()

}  // namespace stillpoint::test
