// SPDX-License-Identifier: MIT
#pragma once

// What can be watched of a motion. The oscillator must outlive the watcher.

#include "watched_motion.hpp"

#include <stillpoint/core/half_cycles.hpp>
#include <stillpoint/core/motion_energies.hpp>
#include <stillpoint/core/trajectory.hpp>

#include <cstdint>
#include <memory>
#include <vector>

namespace stillpoint {

template <class Result>
class Finder : public MotionWatcher {
 public:
  /// After the end.
  [[nodiscard]] virtual Result found() = 0;
};

/// For `to_end` of the same options.
std::unique_ptr<Finder<MotionEnergies>> energy_watcher(const Oscillator& oscillator,
                                                       const Surface& surface, const Start& start,
                                                       const ForcedOptions& options);

std::unique_ptr<Finder<std::vector<HalfCycle>>> half_cycle_watcher(const Oscillator& oscillator,
                                                                   const Surface& surface,
                                                                   std::int64_t most);

/// `pieces` and `to_rest` as in ForcedTrajectoryOptions.
std::unique_ptr<Finder<Path>> path_watcher(const Oscillator& oscillator, std::int64_t pieces,
                                           bool to_rest);

}  // namespace stillpoint
