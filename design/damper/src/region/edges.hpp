// SPDX-License-Identifier: MIT
#pragma once

// The edges of the admissible region and the questions that decide whether it is empty.

#include <stillpoint/design/problem.hpp>

namespace stillpoint::design {

/// The edges as doubles that lie on or inside them: f2 rounded up, f3 and Delta2 down. At beta =
/// V0/(sqrt(2) p) they meet, and one ulp of beta moves f2 by three, which rounding to nearest could
/// hide.
struct Edges {
  double f1;
  double f2;
  double f3;
  double f_max;  ///< the limit of f itself; infinite without one
  double f4;     ///< that of a figure of the motion, docs/theory.md (33); the same
  double delta2;
  double f_cap;      ///< min(f3, f_max, f4)
  double delta_cap;  ///< min(Delta2, delta_max)
};

/// Delta2 = V0^2/2, rounded down.
[[nodiscard]] double largest_delta_of_start(double v0);

[[nodiscard]] Edges edges(const Problem& problem, const Limits& limits);

/// Delta is limited to 0 and no residual is allowed: constant friction alone stops no mass at x =
/// 0.
[[nodiscard]] bool needs_a_notch(const Problem& problem, const Limits& limits);

/// There is an f whose box, of the same tolerance on both sides, lies between the two.
[[nodiscard]] bool box_fits(double floor, double cap, double tolerance);

/// At the largest f within the limits, where Delta1 is smallest, there is a Delta between Delta1
/// and the cap, for the whole box. A smaller v0 or p only helps.
[[nodiscard]] bool stop_fits(const Problem& problem, const Edges& edges, const Limits& limits);

/// Delta1(f) of the problem's criterion, rounded once, next to f3 as well; 0 where the motion does
/// not return. Nothing is checked.
[[nodiscard]] double unchecked_delta1(const Problem& problem, double f);

/// The largest f whose box stays at or below the cap, and the smallest one at or above the floor,
/// as double arithmetic evaluates f (1 + R) and f (1 - R).
[[nodiscard]] double highest_centre(double cap, double tolerance);
[[nodiscard]] double lowest_centre(double floor, double tolerance);

}  // namespace stillpoint::design
