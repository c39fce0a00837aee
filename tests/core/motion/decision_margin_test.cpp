// SPDX-License-Identifier: MIT
#include "motion.hpp"
#include "testing/backward_error.hpp"

namespace stillpoint::test {

BOOST_AUTO_TEST_SUITE(decision_margin_test)

/// Every input changed by a relative `size` at most.
Scene<> shaken(const Scene<>& scene, double size, Dice& dice) {
  Scene<> moved = scene;
  for (const auto input : inputs<double>) {
    const double change = dice.once_in(2) ? dice.sign() : dice.uniform(-1, 1);
    moved.*input *= 1 + size * change;
  }
  return moved;
}

/// The relative change of a single input, up or down, that changes the end; none up to `most`.
std::optional<double> tipping_change(const Scene<>& scene, double Scene<>::*input, double most) {
  std::optional<double> least;
  for (const double far : {most, -most}) {
    const double value = scene.*input;
    if (const std::optional<Scene<>> last = edge(scene, input, value * (1 + far))) {
      const double change = std::abs((*last).*input / value - 1);
      least = least ? std::min(*least, change) : change;
    }
  }
  return least;
}

BOOST_AUTO_TEST_CASE(the_margin_adds_up_what_each_input_alone_would_need) {
  // To first order g changes sign where input i alone changes by e_i = |g| / |input_i dg/dinput_i|,
  // and so the margin |g| / sum |input_i dg/dinput_i| is 1 / sum 1/e_i, or less where it is a
  // bound.
  constexpr double from_edge = 1e-7;
  constexpr double second_order = 1e-3;  // of the margin
  Dice dice(405);
  for (int found = 0; found < 2000;) {
    Scene<> scene = any_start_scene(dice);
    scene.f *= dice.once_in(4) ? 0 : 1;
    std::optional<Scene<>> near_edge = near_tie(scene, dice);
    if (!near_edge) {
      continue;
    }
    const auto moved = near_edge->v0 != 0 ? &Scene<>::v0 : &Scene<>::x0;  // every g holds one
    (*near_edge).*moved *= 1 + dice.sign() * from_edge;
    double sum = 0;
    for (const auto input : inputs<double>) {
      if (const auto change = tipping_change(*near_edge, input, 100 * from_edge)) {
        sum += 1 / *change;
      }
    }
    if (sum > 0) {
      ++found;
      const double margin = response(*near_edge, {.times = false}).decision_margin.value();
      BOOST_TEST(margin * sum <= 1 + second_order, "seed 405, scene " << *near_edge);
    }
  }
}

/// Of one friction alone in every third.
BOOST_AUTO_TEST_CASE(less_than_half_the_margin_changes_no_end) {
  constexpr double smallest_margin = 1e-12;  // below, the scene's own rounding counts
  constexpr std::uint64_t seed = 401;
  Dice dice(seed);
  int shaken_scenes = 0;
  for (int i = 0; i < 9000; ++i) {
    Scene<> scene = any_start_scene(dice);
    if (i % 3 == 0) {
      (dice.once_in(2) || scene.v0 == 0 ? scene.delta : scene.f) = 0;
    }
    const double margin = response(scene).decision_margin.value();
    if (margin < smallest_margin) {
      continue;
    }
    ++shaken_scenes;
    const End end = end_of(scene);
    for (int direction = 0; direction < 20; ++direction) {
      const Scene<> moved = shaken(scene, 0.499 * margin, dice);
      BOOST_TEST(end_of(moved) == end, "seed " << seed << ", margin " << margin << ": " << scene
                                               << " gives " << end << ", " << moved << " gives "
                                               << end_of(moved));
    }
  }
  BOOST_TEST(shaken_scenes > 8700);
}

BOOST_AUTO_TEST_CASE(the_worst_direction_may_need_all_inputs) {
  // At rest at x0 = 1 + 2e-6, f = 1, p = 1: g = p x0 - f/p; x0 and f weigh 1 each, p weighs 2.
  const Scene<> scene{1 + 2e-6, 0, 1, 1, 0.5};
  const double margin = response(scene).decision_margin.value();
  near("decision_margin", margin, 2e-6 / 4, 1e-5);
  const auto moved = [&](double size) {
    return Scene<>{scene.x0 * (1 - size), 0, 1 - size, 1 + size, 0.5};
  };
  BOOST_TEST(end_of(moved(0.999 * margin)) == end_of(scene));
  BOOST_TEST(end_of(moved(1.001 * margin)).half_cycles == 0);
}

BOOST_AUTO_TEST_CASE(the_margin_is_zero_on_an_exact_tie) {
  for (const Scene<>& tie : {Scene<>{0, 24, 1, 7, 36},
                             {4, 12, 1, 5, 0.5},
                             {4, 12, 1, 5, 0},
                             {3, 6, 1, 5, 0.5},
                             {0, 2, 1, 0, 2},
                             {0, 1, 1, 0, 0.125},
                             {1, 0, 1, 1, 0.5},
                             {2, -4, 1, 5, 0.5},
                             {10, 20, 1, 5, 0}}) {
    BOOST_TEST_CONTEXT("scene " << tie) {
      BOOST_TEST(response(tie).decision_margin.value() == 0);
    }
  }
}

BOOST_AUTO_TEST_CASE(next_to_a_change_of_the_end_the_margin_is_a_matter_of_rounding) {
  Dice dice(404);
  for (int found = 0; found < 2000;) {
    const Scene<> scene = any_start_scene(dice);
    if (const std::optional<Scene<>> tie = near_tie(scene, dice)) {
      ++found;
      const Response r = response(*tie, {.times = false});
      // Up to 3 units in the last place from the edge.
      const double bound = 8e-16 + allowed_change(*r.half_cycles);
      BOOST_TEST(r.decision_margin.value() <= bound, "scene " << *tie);
    }
  }
}

BOOST_AUTO_TEST_CASE(an_absent_kind_of_friction_decides_nothing) {
  BOOST_TEST(!response({0, 1, 1, 0, 0}).decision_margin);
  // f = 0, v0 = 2, Delta = 0.5: last passage at v^2 = 1 + 1 - 1 = 1 of spread 2 * 4 + 3.
  near("decision_margin", response({0, 2, 1, 0, 0.45}).decision_margin.value(), 0.4 / (8 + 4 * 0.9),
       1e-14);
}

BOOST_AUTO_TEST_SUITE_END()

}  // namespace stillpoint::test
