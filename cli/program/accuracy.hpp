// SPDX-License-Identifier: MIT
#pragma once

#include "settings.hpp"

#include <stillpoint/core/simulation.hpp>
#include <stillpoint/peers/scene.hpp>

namespace stillpoint::cli {

/// What the methods are compared on. Throws UsageError for a motion that never stops and one that
/// is too long for 50 digits.
[[nodiscard]] peers::Scene comparison_scene(const SimulationRequest& request);

}  // namespace stillpoint::cli
