// SPDX-License-Identifier: MIT
#pragma once

// One half-cycle back, (39), in 64 bits, for decisions that are right to the last bit.

#include "wide.hpp"

#include <cmath>

namespace stillpoint::design {

[[nodiscard]] inline double least_double_from(Wide value) {
  const auto nearest = static_cast<double>(value);
  return nearest < value ? std::nextafter(nearest, HUGE_VAL) : nearest;
}

/// In speeds: phi = f/p, d = 2 Delta.
struct WideNotch {
  Wide phi;
  Wide d;

  [[nodiscard]] Wide before(Wide radius) const { return 2 * phi + root(radius * radius + d); }
  [[nodiscard]] Wide square_before(Wide radius, int steps) const {
    for (int i = 0; i < steps; ++i) {
      radius = before(radius);
    }
    return (radius - phi) * (radius + phi);
  }
  /// The least V0 whose first half-cycle has that radius or a larger one.
  [[nodiscard]] double speed(Wide radius) const {
    return least_double_from(root((radius - phi) * (radius + phi)));
  }
};

}  // namespace stillpoint::design
