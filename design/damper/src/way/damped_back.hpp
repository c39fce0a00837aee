// SPDX-License-Identifier: MIT
#pragma once

#include "way/unit_strip.hpp"

namespace stillpoint::design::unit {

/// followed_back() with damping: docs/damping.md (D20).
[[nodiscard]] EdgeSpeed damped_back(const EdgeStart& start, int steps, double d);

}  // namespace stillpoint::design::unit
