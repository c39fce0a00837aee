// SPDX-License-Identifier: MIT
#pragma once

// Scenes on the edge of a decision, found by bisection to neighbouring doubles.

#include "testing/exact_run.hpp"
#include "testing/random_scene.hpp"

namespace stillpoint::test {

inline End end_of(const Scene<double>& scene) {
  return as_run(response(scene, {.times = false, .margin = false})).end;
}

/// `scene` with `input` moved from its value towards `far` to the first change of the outcome that
/// bisection finds: the nearest double on the near side. Empty if the ends are equal.
inline std::optional<Scene<double>> edge(Scene<double> scene, double Scene<double>::*input,
                                         double far) {
  const End near_end = end_of(scene);
  Scene<double> other = scene;
  other.*input = far;
  if (end_of(other) == near_end) {
    return std::nullopt;
  }
  while (true) {
    const double middle = scene.*input + (other.*input - scene.*input) / 2;
    if (middle == scene.*input || middle == other.*input) {
      return scene;
    }
    Scene<double> between = scene;
    between.*input = middle;
    if (end_of(between) == near_end) {
      scene = between;
    } else {
      other = between;
    }
  }
}

/// `scene` moved to an edge in f, delta, or where there is one x0, then by up to 3 units in the
/// last place to either side.
inline std::optional<Scene<double>> near_tie(const Scene<double>& scene, Dice& dice) {
  constexpr auto tuned = std::to_array(
      {&Scene<double>::f, &Scene<double>::delta, &Scene<double>::x0, &Scene<double>::v0});
  const auto input = tuned[dice.below(scene.x0 == 0 ? 2 : 4)];
  std::optional<Scene<double>> found = edge(scene, input, scene.*input * dice.uniform(0.6, 1.6));
  if (found) {
    const double value = (*found).*input;
    (*found).*input =
        std::copysign(nudged(std::abs(value), static_cast<int>(dice.below(7)) - 3), value);
  }
  return found;
}

}  // namespace stillpoint::test
