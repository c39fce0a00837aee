// SPDX-License-Identifier: MIT
#pragma once

#include <stillpoint/core/names.hpp>

#include <span>

namespace stillpoint {

/// Where a motion is: x and v = x' at tau.
struct State {
  double tau{0};
  double x{0};
  double v{0};
};

/// How a motion ends. All are legitimate: none is an error.
enum class Outcome {
  stopped_at_zero,       ///< rests at x = 0, held by the notch or arrived without speed
  stopped_in_dead_zone,  ///< rests at 0 < |x| <= f/p^2
  never_stops,           ///< no friction at all
  caught_at_start,       ///< v0^2 < 2 delta at x = 0: the notch never lets it go
  running,               ///< forced motion only: not known to have stopped when the run ended
  stopped_in_notch,      ///< rests at 0 < |x| <= w/2 in a notch of width w (surface.hpp)
};

/// In the order of reports.
[[nodiscard]] std::span<const Named<Outcome>> enumerators(Outcome) noexcept;

/// What happens in a motion, in the order in which simultaneous events take effect: docs/forced.md
/// section 1. A free motion has no event of the excitation, no stick and no end but its rest.
enum class EventKind {
  start,
  arrival,         ///< x = 0, with the speed before the notch
  passage,         ///< the same instant, with the speed after it
  turn,            ///< x' = 0, reached from motion; in a free motion, one that it goes on from
  excitation_end,  ///< W = 0 from here on
  stick,           ///< friction holds the mass for a while, or for ever
  release,         ///< the end of a stick
  rest,            ///< the final rest
  end,             ///< the end of the run, if the motion goes on
};

struct Event {
  EventKind kind{EventKind::start};
  State state;
};

}  // namespace stillpoint
