// SPDX-License-Identifier: MIT
#pragma once

#include <optional>
#include <string_view>

namespace stillpoint {

/// What happens in a forced motion, in the order in which simultaneous events take effect:
/// docs/forced.md section 1.
enum class ForcedEventKind {
  start,
  arrival,         ///< x = 0, with the speed before the notch
  passage,         ///< the same instant, with the speed after it
  turn,            ///< x' = 0, reached from motion
  excitation_end,  ///< W = 0 from here on
  stick,           ///< friction holds the mass for a while, or for ever
  release,         ///< the end of a stick
  rest,            ///< the final rest
  end,             ///< the end of the run, if the motion goes on
};

/// The name in output: the enumerator's own.
[[nodiscard]] std::string_view name(ForcedEventKind kind) noexcept;

/// The enumerator of that name; empty where there is none.
[[nodiscard]] std::optional<ForcedEventKind> parse_forced_event_kind(
    std::string_view name) noexcept;

}  // namespace stillpoint
