// SPDX-License-Identifier: MIT
#pragma once

// The vector kernel of free batches with damping, damped_lanes.cpp, as the rest of core sees it.

#include "batch_entries.hpp"
#include "interface.hpp"

#include <array>
#include <cstddef>

namespace stillpoint {

/// The numbers of a lane.
enum class LaneValue : std::size_t {
  phi,
  held,
  notch,
  zeta,
  decay,
  speed,     ///< with which it leaves x = 0 next
  phase,     ///< DampedEnd, as the next four
  passages,  ///< of x = 0
  farthest,
  peak,
  excursion,
  late,  ///< from x = 0, reached by the excursion, to its peak
  count
};

using LaneValues = std::array<double, static_cast<std::size_t>(LaneValue::count)>;

/// Where the lanes get their work.
class DampedLanesSource : public Interface {
 public:
  /// Gives the lane the start of its next entry, after it has done with the ones not for lanes;
  /// false where there are no more.
  virtual bool begin(std::size_t lane, LaneValues& values) = 0;
  /// The entry of the lane has ended.
  virtual void end(std::size_t lane, const LaneValues& values) = 0;
  /// Asked now and then: when it returns false the results are no longer wanted.
  [[nodiscard]] virtual bool goes_on() = 0;
};

/// Runs all entries of `source`, by the widest instruction set of this machine.
void run_damped_lanes(DampedLanesSource& source);

}  // namespace stillpoint
