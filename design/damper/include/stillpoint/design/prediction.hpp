// SPDX-License-Identifier: MIT
#pragma once

// What the formulas of a design predict of its motion.

#include <stillpoint/design/problem.hpp>

namespace stillpoint::design {

/// A motion that comes to rest, by whatever method.
struct MotionFigures {
  double peak_amplitude{0};     ///< (24)
  double peak_acceleration{0};  ///< S
  double stop_time{0};          ///< (25)
  double arrival_speed{0};
  double half_cycles{1};
  double stop_position{0};
};

/// The motion of an admissible (f, Delta) by the formulas of the design: it stops at x = 0 on the
/// first return, or at a later arrival. Closed forms of docs/theory.md sections 7 and 12, not taken
/// from the kernel.
using Prediction = MotionFigures;

/// For the first arrival. Throws InputError unless 0 <= f <= f3.
[[nodiscard]] Prediction predict(const Problem& problem, double f);
/// For the arrival at which (f, delta) stops the mass. Throws InputError if it stops it at none
/// that is allowed.
[[nodiscard]] Prediction predict(const Problem& problem, double f, double delta);

}  // namespace stillpoint::design
