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

/// The free kernel for a half-cycle in each of its modes, free_peak for a motion, and what the
/// hardware's square root takes.
[[nodiscard]] std::vector<Unit> free_modes(const peers::Scene& scene,
                                           const peers::MeasureOptions& options);

}  // namespace stillpoint::bench
