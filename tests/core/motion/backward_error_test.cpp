// SPDX-License-Identifier: MIT
#include "testing/backward_error.hpp"
#include "motion.hpp"

// The accuracy promise on seeded random scenes, against 50 digits.

namespace stillpoint::test {

BOOST_AUTO_TEST_SUITE(backward_error_test)

// The sanitizers make 50 digits ten times slower: there they see a fifth of the scenes.
#ifdef __SANITIZE_ADDRESS__
constexpr int one_in = 5;
#else
constexpr int one_in = 1;
#endif

/// `count` scenes made by `make(dice)`, which may give none.
template <class Make>
void check_scenes(std::uint64_t seed, int count, Make make) {
  Dice dice(seed);
  BOOST_TEST_CONTEXT("seed " << seed) {
    for (int checked = 0; checked < count / one_in;) {
      if (const std::optional<Scene<>> scene = make(dice)) {
        keeps_the_promise(*scene);
        ++checked;
      }
    }
  }
}

/// One friction is moderate, so that the motion is short; the other may be tiny.
Scene<> tiny_friction_scene(Dice& dice) {
  Scene<> scene = any_start_scene(dice);
  double& tiny = dice.once_in(2) ? scene.f : scene.delta;
  tiny = dice.once_in(8) ? 0 : dice.power_of_ten(-300, -1) * tiny;
  return scene;
}

/// Speeds and frequencies from 1e-149 to 1e149; the ends themselves have a case of their own.
Scene<> extreme_scale_scene(Dice& dice) {
  Scene<> scene = any_start_scene(dice);
  const double speed = dice.power_of_ten(-145, 145);
  const double p = dice.power_of_ten(-147, 147);
  // x0 in units of speed / p, f of speed * p, delta of speed^2.
  return {scene.x0 * (speed / p), scene.v0 * speed, scene.p * p, scene.f * (speed * p),
          scene.delta * speed * speed};
}

BOOST_AUTO_TEST_CASE(motions_from_any_start_keep_the_promise) {
  check_scenes(101, 8000, any_start_scene);
}

BOOST_AUTO_TEST_CASE(overwhelming_friction_keeps_the_promise) {
  check_scenes(103, 4000, [](Dice& dice) {
    Scene<> scene = any_start_scene(dice);
    const double speed = std::abs(scene.v0) + scene.p * std::abs(scene.x0);
    scene.f = speed * scene.p * dice.power_of_ten(-0.5, 8);
    return std::optional(scene);
  });
}

BOOST_AUTO_TEST_CASE(vanishing_friction_keeps_the_promise) {
  check_scenes(104, 2000, tiny_friction_scene);
}

BOOST_AUTO_TEST_CASE(extreme_scales_keep_the_promise) {
  check_scenes(105, 3000, [](Dice& dice) -> std::optional<Scene<>> {
    const Scene<> scene = extreme_scale_scene(dice);
    const double reach = std::abs(scene.p * scene.x0);
    const bool in_range = scene.f <= 1e300 && scene.delta <= 1e300 && std::abs(scene.x0) <= 1e300 &&
                          (scene.x0 == 0 || (reach >= 1e-150 && reach <= 1e150));
    return in_range ? std::optional(scene) : std::nullopt;
  });
}

BOOST_AUTO_TEST_CASE(one_friction_alone_keeps_the_promise_over_up_to_1e9_half_cycles) {
  check_scenes(109, 3000, [](Dice& dice) {
    Scene<> scene = any_start_scene(dice);
    const bool constant = dice.once_in(2);
    (constant ? scene.delta : scene.f) = 0;
    (constant ? scene.f : scene.delta) *= dice.power_of_ten(-7, 0);
    return dice.once_in(2) ? near_tie(scene, dice) : std::optional(scene);
  });
}

BOOST_AUTO_TEST_CASE(a_million_half_cycles_with_both_frictions_keep_the_promise) {
  // Extended precision is enough here: 1e6 * 5e-20 of rounding against a promise of 2e-10. The
  // motion is 1e-7 from its nearest decision, far more than the step of the differences.
  if (std::numeric_limits<long double>::digits < 64) {
    BOOST_TEST_MESSAGE("skipped: long double is no wider than double");
    return;
  }
  const Scene<> scene{0.3, 1, 1.25, 2.5e-7, 2e-7};
  const Scene<long double> wide = widened<long double>(scene);
  const Run<long double> reference = run_in(wide);
  const std::array<long double, 5> sums = conditions(wide, reference, 1e-11L);
  Run<Exact> exact{reference.end, {}, Exact(*reference.margin)};
  std::array<Exact, 5> exact_sums;
  for (std::size_t i = 0; i < sums.size(); ++i) {
    exact.metrics[i] = Exact(reference.metrics[i].value());
    exact_sums[i] = sums[i];
  }
  const Run<double> run = as_run(response(scene));
  BOOST_TEST(run.end.half_cycles > 1e6);
  BOOST_TEST(ends_agree(run, exact));
  metrics_agree(run, exact, exact_sums);
}

BOOST_AUTO_TEST_CASE(the_ends_of_the_range_keep_the_promise) {
  for (const double v0 : {1e-150, 1.0, 1e150}) {
    for (const double p : {1e-150, 1.0, 1e150}) {
      for (const double friction : {0.0, 0.02, 0.3, 1.0}) {
        for (const double notch : {0.0, 0.02, 0.3}) {
          if (friction + notch > 0) {
            keeps_the_promise({0, v0, p, friction * (v0 * p), notch * (v0 * v0)});
          }
        }
      }
    }
  }
}

/// Of one friction alone in every third.
BOOST_AUTO_TEST_CASE(near_ties_keep_the_promise) {
  check_scenes(106, 12000, [](Dice& dice) {
    Scene<> scene = any_start_scene(dice);
    if (dice.once_in(3)) {
      (dice.once_in(2) ? scene.f : scene.delta) = 0;
    }
    return near_tie(scene, dice);
  });
}

BOOST_AUTO_TEST_SUITE_END()

}  // namespace stillpoint::test
