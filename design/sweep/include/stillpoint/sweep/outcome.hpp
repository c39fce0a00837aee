// SPDX-License-Identifier: MIT
#pragma once

#include <stillpoint/core/outcome.hpp>

#include <cstddef>
#include <string_view>

namespace stillpoint::sweep {

/// How an entry of a sweep ends: an Outcome, by its number, or this one after them.
inline constexpr std::size_t too_many_half_cycles = static_cast<std::size_t>(Outcome::running) + 1;
inline constexpr std::size_t sweep_outcome_count = too_many_half_cycles + 1;

/// The name in rows and reports.
[[nodiscard]] inline std::string_view sweep_outcome_name(std::size_t outcome) {
  return outcome == too_many_half_cycles ? "too_many_half_cycles"
                                         : name(static_cast<Outcome>(outcome));
}

}  // namespace stillpoint::sweep
