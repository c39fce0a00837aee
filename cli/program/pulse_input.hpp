// SPDX-License-Identifier: MIT
#pragma once

#include "settings.hpp"

#include <stillpoint/design/pulse.hpp>

#include <optional>
#include <string>

namespace stillpoint::cli {

/// half-sine or rectangle; empty where there is no pulse. Throws InputError for another.
[[nodiscard]] std::optional<std::string> pulse_type(const Settings& settings);

/// The pulse that gives the initial velocity of a design; empty where none is asked for. Throws
/// UsageError for its options without it, and InputError for a wrong value.
[[nodiscard]] std::optional<design::Pulse> pulse_input(const Settings& settings);

}  // namespace stillpoint::cli
