// SPDX-License-Identifier: MIT
#pragma once

#include "settings.hpp"

#include <stillpoint/design/pulse.hpp>

#include <optional>

namespace stillpoint::cli {

/// The pulse that gives the initial velocity of a design; empty where none is asked for. Throws
/// UsageError for its options without it, and InputError for a wrong value.
[[nodiscard]] std::optional<design::Pulse> pulse_input(const Settings& settings);

}  // namespace stillpoint::cli
