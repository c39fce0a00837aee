// SPDX-License-Identifier: MIT
#pragma once

// Seeded random scenes. The engine's bits and the arithmetic below are the same on every machine;
// std::uniform_real_distribution need not be.

#include "testing/scene.hpp"

#include <cmath>
#include <cstdint>
#include <random>

namespace stillpoint::test {

class Dice {
 public:
  explicit Dice(std::uint64_t seed) : engine_(seed) {}

  /// In [low, high).
  double uniform(double low, double high) {
    return low + (high - low) * std::ldexp(static_cast<double>(engine_() >> 11U), -53);
  }
  /// 10^low to 10^high, evenly in the exponent.
  double power_of_ten(double low, double high) { return std::pow(10.0, uniform(low, high)); }
  double sign() { return (engine_() >> 63U) == 0 ? 1 : -1; }
  bool once_in(unsigned times) { return (engine_() >> 33U) % times == 0; }
  /// 0, 1, ..., count - 1.
  unsigned below(unsigned count) { return static_cast<unsigned>((engine_() >> 33U) % count); }

 private:
  std::mt19937_64 engine_;
};

/// From x = 0, everything of moderate size, up to fifty half-cycles or so.
inline Scene<> moderate_scene(Dice& dice) {
  const double v0 = dice.power_of_ten(-2, 2);
  const double p = dice.power_of_ten(-2, 2);
  return {0, dice.sign() * v0, p, v0 * p * dice.power_of_ten(-2, 0.6),
          v0 * v0 * dice.power_of_ten(-2, -0.25)};
}

/// Any start: outwards, inwards, from rest; x0 about v0 / p or far from it.
inline Scene<> general_start_scene(Dice& dice) {
  Scene<> scene = moderate_scene(dice);
  scene.x0 = dice.sign() * (std::abs(scene.v0) / scene.p) * dice.power_of_ten(-1.5, 0.5);
  if (dice.once_in(5)) {
    scene.v0 = 0;
  }
  return scene;
}

/// One or the other.
inline Scene<> any_start_scene(Dice& dice) {
  return dice.once_in(2) ? moderate_scene(dice) : general_start_scene(dice);
}

/// `value` moved by `steps` units in the last place.
inline double nudged(double value, int steps) {
  const double target = steps < 0 ? 0.0 : HUGE_VAL;
  for (int i = 0; i < std::abs(steps); ++i) {
    value = std::nextafter(value, target);
  }
  return value;
}

}  // namespace stillpoint::test
