// SPDX-License-Identifier: MIT
#pragma once

// The whole motion of a hit, wherever it comes to rest: docs/theory.md sections 3 and 5, in the
// units of unit_problem.hpp. Not taken from the kernel.

namespace stillpoint::design::unit {

struct Rest {
  double phase{0};  ///< p T
  int half_cycles{0};
  double position{0};       ///< p x / V0; 0 where it stops at x = 0
  double arrival_speed{0};  ///< of the last arrival, over V0; 0 without one
  double grazing{0};        ///< the error of phase and position over that of the energies, as (53)
};

/// Followed for at most that many half-cycles. `error` is the absolute one of (w / V0)^2.
[[nodiscard]] Rest rest(double a, double d, int most, double error = 1e-16);

}  // namespace stillpoint::design::unit
