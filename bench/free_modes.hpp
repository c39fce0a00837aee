// SPDX-License-Identifier: MIT
#pragma once

#include <stillpoint/peers/measure.hpp>

#include <stillpoint/peers/scene.hpp>

#include <string>
#include <vector>

namespace stillpoint::bench {

/// Nanoseconds for one of something.
struct Unit {
  std::string what;
  peers::Timing seconds;
};

/// In other units.
void scale(peers::Timing& timing, double by);

/// Times of the free kernel per half-cycle in each mode, of free_peak per motion, and of the
/// hardware square root.
[[nodiscard]] std::vector<Unit> free_modes(const peers::Scene& scene,
                                           const peers::MeasureOptions& options);

}  // namespace stillpoint::bench
