// SPDX-License-Identifier: MIT
#pragma once

#include "settings.hpp"

#include <stillpoint/sweep/spec.hpp>

namespace stillpoint::cli {

/// What the settings ask of a sweep. Opens the list and reads its header. Throws UsageError for
/// something missing or contradictory and InputError for a wrong value.
[[nodiscard]] sweep::SweepSpec sweep_request(const Settings& settings);

}  // namespace stillpoint::cli
