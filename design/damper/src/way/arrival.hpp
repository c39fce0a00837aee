// SPDX-License-Identifier: MIT
#pragma once

// At which arrival one damper stops one hit.

#include <stillpoint/design/problem.hpp>

namespace stillpoint::design {

/// The task of only the motion shown, by the model itself.
[[nodiscard]] Problem strongest_hit(Problem problem);

/// The arrival that decides about a damper: that at which it stops the mass, or else the first one
/// that the mass does not reach, or the last one allowed if it passes all.
struct DecidingArrival {
  int n;
  bool stops;
};
[[nodiscard]] DecidingArrival deciding_arrival(const Problem& problem, double f, double delta);

}  // namespace stillpoint::design
