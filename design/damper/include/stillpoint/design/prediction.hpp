// SPDX-License-Identifier: MIT
#pragma once

// What the formulas of a design predict of its motion, and what another method finds.

#include <stillpoint/design/problem.hpp>

#include <string_view>
#include <vector>

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

/// The motion under a record by another method.
struct CheckedMotion {
  double peak{0};
  double acceleration{0};
  double residual{0};
  double relative_error{0};  ///< of peak and acceleration; of residual over the peak
};

/// An independent method for the same quantities, and its distance from the prediction.
struct CheckMethod : MotionFigures {
  std::string_view name;  ///< half_cycle_map, runge_kutta or forced_pulse
  double tolerance{0};    ///< for relative_error
  /// The largest of |stop_position| / peak_amplitude, the error of arrival_speed over v0, and the
  /// relative errors of the other three.
  double relative_error{0};
  double wall_time_s{0};
  /// False if the design is so close to a tie that the rounding of this method decides whether the
  /// mass passes x = 0; then only the peak is judged, and relative_error is that of the peak.
  bool decided{true};
  /// relative_error <= tolerance and, if decided, the predicted half_cycles and a stop at x = 0.
  bool passed{false};
  std::vector<CheckedMotion> motions{};  ///< under records, in place of the figures
};

}  // namespace stillpoint::design
