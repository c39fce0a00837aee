// SPDX-License-Identifier: MIT
#pragma once

// The edges of the admissible region and the two questions that decide whether it is empty.

#include <stillpoint/design/problem.hpp>

namespace stillpoint::design {

/// The paper's f2 and f3 in long double: at beta = V0/(sqrt(2) p) they meet, and one ulp of beta
/// moves f2 by three, which their rounding to double could hide.
struct Edges {
  long double f2;
  long double f3;
  double f_cap;      ///< min(f3, f_max)
  double delta_cap;  ///< min(Delta2, delta_max)
};

[[nodiscard]] Edges edges(const Problem& problem, const Limits& limits);

/// f2 (1 + R) <= f3 (1 - R) and f2 (1 + R) <= f_max (1 - R). More beta or p, or less v0, only
/// helps.
[[nodiscard]] bool amplitude_fits_return(const Edges& edges, const Limits& limits);
[[nodiscard]] bool amplitude_fits_f_max(const Edges& edges, const Limits& limits);

/// At the largest f that the limits leave, where Delta1 is least, there is a Delta between Delta1
/// and the cap, for the whole box. Less v0 or p only helps.
[[nodiscard]] bool stop_fits(const Problem& problem, const Edges& edges, const Limits& limits);

/// The largest f whose box stays at or below the cap, and the smallest one at or above the floor,
/// as double arithmetic evaluates f (1 + R) and f (1 - R).
[[nodiscard]] double highest_centre(double cap, double tolerance);
[[nodiscard]] double lowest_centre(double floor, double tolerance);

}  // namespace stillpoint::design
