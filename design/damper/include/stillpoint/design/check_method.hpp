// SPDX-License-Identifier: MIT
#pragma once

#include <stillpoint/design/prediction.hpp>

#include <string_view>

namespace stillpoint::design {

/// An independent method for the same quantities, and its distance from the prediction.
struct CheckMethod : MotionFigures {
  std::string_view name;  ///< half_cycle_map or runge_kutta
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
};

}  // namespace stillpoint::design
