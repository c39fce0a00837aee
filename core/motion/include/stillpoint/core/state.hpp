// SPDX-License-Identifier: MIT
#pragma once

#include <optional>
#include <string_view>

namespace stillpoint {

/// Where a motion is: x and v = x' at tau.
struct State {
  double tau{0};
  double x{0};
  double v{0};
};

/// What happens in a motion, in the order in which simultaneous events take effect: docs/forced.md
/// section 1. A free motion has no event of the excitation, no stick and no end but its rest.
enum class EventKind {
  start,
  arrival,         ///< x = 0, with the speed before the notch
  passage,         ///< the same instant, with the speed after it
  turn,            ///< x' = 0, reached from motion; of a free motion one that goes on from there
  excitation_end,  ///< W = 0 from here on
  stick,           ///< friction holds the mass for a while, or for ever
  release,         ///< the end of a stick
  rest,            ///< the final rest
  end,             ///< the end of the run, if the motion goes on
};

/// The name in output: the enumerator's own.
[[nodiscard]] std::string_view name(EventKind kind) noexcept;

/// The enumerator of that name; empty where there is none.
[[nodiscard]] std::optional<EventKind> parse_event_kind(std::string_view name) noexcept;

struct Event {
  EventKind kind{EventKind::start};
  State state;
};

}  // namespace stillpoint
