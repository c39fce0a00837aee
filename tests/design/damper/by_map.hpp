// SPDX-License-Identifier: MIT
#pragma once

// The truth about one hit: the half-cycle map forwards, in long double, which the library follows
// backwards; docs/theory.md section 12.

#include "task.hpp"

namespace stillpoint::design_test::by_map {

using Wide = long double;

/// The arrival at which the mass stops at x = 0 with the peak within beta; 0 if there is none. The
/// published criterion asks at the last arrival that the speed at x = f/p^2 be small enough.
inline int arrival(const design::Problem& problem, Wide f, Wide delta) {
  const Wide phi = f / problem.p;
  const Wide d = 2 * delta;
  const Wide v0 = problem.v0;
  Wide r = std::sqrt(v0 * v0 + phi * phi);
  if (v0 * v0 < d || r - phi > Wide(problem.p) * problem.beta) {
    return 0;
  }
  for (int n = 1; n <= problem.arrivals && r >= 3 * phi; ++n) {
    const Wide t = r - 2 * phi;
    const Wide square = t * t - phi * phi;
    if (problem.criterion == design::Criterion::published ? t * t < d : square < d) {
      return n;
    }
    if (square < d) {
      return 0;  // it stops here, but the published criterion does not guarantee it
    }
    r = std::sqrt(t * t - d);
  }
  return 0;
}

/// Whether the box f (1 +- R), delta (1 +- R) stops the mass at one arrival and is within the
/// limits: its weakest and its strongest corner decide.
inline bool box_holds(const Task& task, Wide f, Wide delta, Wide r) {
  const auto& [problem, limits, seed] = task;
  const Wide p_v0 = Wide(problem.p) * problem.v0;
  const Wide most = f * (1 + r);
  const int low = arrival(problem, f * (1 - r), delta * (1 - r));
  return low > 0 && low == arrival(problem, most, delta * (1 + r)) &&
         (!limits.f_max || most <= *limits.f_max) &&
         (!limits.delta_max || delta * (1 + r) <= *limits.delta_max) &&
         (!limits.acceleration_max ||
          std::sqrt(most * most + p_v0 * p_v0) <= *limits.acceleration_max);
}

/// The largest R of a point by bisection, -1 if it is below `least`.
inline double tolerance(const Task& task, double f, double delta, Wide least = 0) {
  if (!box_holds(task, f, delta, least)) {
    return -1;
  }
  Wide low = least;
  Wide high = 1;
  while (high - low > 1e-18L) {
    const Wide middle = (low + high) / 2;
    (box_holds(task, f, delta, middle) ? low : high) = middle;
  }
  return static_cast<double>(low);
}

}  // namespace stillpoint::design_test::by_map
