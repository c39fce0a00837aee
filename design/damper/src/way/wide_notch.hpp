// SPDX-License-Identifier: MIT
#pragma once

// One half-cycle back, (39), in long double, for decisions that are right to the last bit.

#include <cmath>

namespace stillpoint::design {

[[nodiscard]] inline double least_double_from(long double value) {
  const auto nearest = static_cast<double>(value);
  return nearest < value ? std::nextafter(nearest, HUGE_VAL) : nearest;
}

/// In speeds: phi = f/p, d = 2 Delta.
struct WideNotch {
  long double phi;
  long double d;

  [[nodiscard]] long double before(long double radius) const {
    return 2 * phi + std::sqrt(radius * radius + d);
  }
  [[nodiscard]] long double square_before(long double radius, int steps) const {
    for (int i = 0; i < steps; ++i) {
      radius = before(radius);
    }
    return (radius - phi) * (radius + phi);
  }
  /// The least V0 whose first half-cycle has that radius or a larger one.
  [[nodiscard]] double speed(long double radius) const {
    return least_double_from(std::sqrt((radius - phi) * (radius + phi)));
  }
};

}  // namespace stillpoint::design
