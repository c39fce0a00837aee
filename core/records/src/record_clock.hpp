// SPDX-License-Identifier: MIT
#pragma once

#include <stillpoint/core/oscillator.hpp>

#include <string_view>

namespace stillpoint::records {

/// What the times of a record count, and which of them a motion can follow, excitation.hpp. It is
/// asked while the file is read, where its lines are known.
struct RecordClock {
  std::string_view unit{"s"};
  double per_tau{1};  ///< of this unit; > 0
  double p{1};        ///< of the oscillator; > 0

  /// The shortest time between two values, rounded.
  [[nodiscard]] double shortest() const { return smallest_speed / (p < 1 ? p : 1) * per_tau; }
  [[nodiscard]] double latest() const { return largest_speed * per_tau; }
  /// The largest value in g.
  [[nodiscard]] double largest_load() const { return largest_speed * (p < 1 ? p : 1); }
  [[nodiscard]] bool reaches(double time) const { return time / per_tau <= largest_speed; }
  /// Whether the motion sees `time` behind `before`.
  [[nodiscard]] bool tells_apart(double before, double time) const {
    return p * (time / per_tau - before / per_tau) >= smallest_speed &&
           time / per_tau - before / per_tau >= smallest_speed;
  }
};

}  // namespace stillpoint::records
