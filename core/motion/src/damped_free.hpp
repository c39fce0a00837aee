// SPDX-License-Identifier: MIT
#pragma once

// Free motions with damping by a map of half-cycles: docs/damping.md section 4. In units where p
// = 1.

#include "kernel/piece_end.hpp"

#include <stillpoint/core/free_motion.hpp>

#include <optional>

namespace stillpoint {

/// What damping makes of every motion.
struct DampedCycle {
  double zeta{0};
  double swing{0};  ///< pi / omega: from one turn to the next
  double decay{1};  ///< exp(-zeta swing)
};

[[nodiscard]] DampedCycle damped_cycle(double zeta);

/// A motion from x = 0 or from a turn, on the paper's surface.
struct DampedFree {
  double p{1};
  int side{1};      ///< of x on its first half-cycle
  double phi{0};    ///< f / p
  double held{0};   ///< the dead zone: friction at rest over p
  double notch{0};  ///< 2 Delta
  DampedCycle cycle;
  double speed{0};  ///< with which it leaves x = 0; 0 if it begins at a turn
  double peak{0};   ///< |x| of that turn; 0 if it begins at x = 0
};

/// What its half-cycles leave; the last one has no passage.
struct DampedEnd {
  double farthest{0};   ///< the first peak
  double peak{0};       ///< the last one
  double excursion{0};  ///< what would follow it without a notch; < 0: it turns before x = 0
  bool at_zero{false};
  double passages{0};
  double phase{0};  ///< without the swings from turn to turn
};

/// The motion, if the map follows it: with damping and something else that takes energy, not held
/// at once, nor so close to it that rounding decides, and of no extreme size. Otherwise ForcedRun
/// does.
[[nodiscard]] std::optional<DampedFree> damped_free(const Oscillator& oscillator,
                                                    const Start& start, const DampedCycle& cycle);

[[nodiscard]] Response damped_response(const DampedFree& motion, const FreeOptions& options);

/// The first peak, |x|.
[[nodiscard]] double first_peak(const DampedFree& motion);

/// The largest of what the structure feels: on the first half-cycle.
[[nodiscard]] double largest_acceleration(const DampedFree& motion);

/// How it ends: the metrics that a batch has as well.
[[nodiscard]] Response response_of(const DampedFree& motion, const DampedEnd& end);

}  // namespace stillpoint
