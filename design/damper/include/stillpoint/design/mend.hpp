// SPDX-License-Identifier: MIT
#pragma once

#include <string_view>
#include <vector>

namespace stillpoint::design {

/// The least change of one input, with the others unchanged, that makes the region not empty.
struct Mend {
  std::string_view
      field;  ///< v0 (for a pulse k, lambda), p, beta, f_max, delta_max, acceleration_max,
  ///< tolerance or arrivals
  double value{0};
  bool upwards{false};  ///< it must increase, not decrease
};

/// The changes that help if no single input suffices, because no damper has the tolerance.
struct JointMend {
  double largest_tolerance{0};  ///< of any damper, for any beta and limits
  /// The tolerance and another input, both changed by the same factor, which is the least that
  /// makes the region not empty. Neither can be closer to its old value unless the other is farther
  /// from its own.
  std::vector<Mend> mends;
};

}  // namespace stillpoint::design
