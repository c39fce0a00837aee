// SPDX-License-Identifier: MIT
#pragma once

#include <stillpoint/core/names.hpp>

#include <span>

namespace stillpoint {

/// How a motion ends. All are legitimate: none is an error.
enum class Outcome {
  stopped_at_zero,       ///< rests at x = 0, held by the notch or arrived without speed
  stopped_in_dead_zone,  ///< rests at 0 < |x| <= f/p^2
  never_stops,           ///< no friction at all
  caught_at_start,       ///< v0^2 < 2 delta at x = 0: the notch never lets it go
  running,               ///< forced motion only: not known to have stopped when the run ended
  stopped_in_notch,      ///< rests at 0 < |x| <= w/2 in a notch of width w (surface.hpp)
};

/// Their names are those of the enumerators.
[[nodiscard]] std::span<const Named<Outcome>> enumerators(Outcome) noexcept;

}  // namespace stillpoint
