// SPDX-License-Identifier: MIT
#pragma once

// The admissible region where a pulse leaves the initial velocity V(f), docs/theory.md section 8.
// V falls with f, so the box f (1 +- R) is tightest where the free one is, at its two corners, with
// the velocity of either.

#include <stillpoint/design/problem.hpp>
#include <stillpoint/design/pulse.hpp>
#include <stillpoint/design/search.hpp>

#include <optional>

namespace stillpoint::design {

/// A problem and limits of constant velocity.
struct FreeTask {
  Problem problem;
  Limits limits;
};

/// For the box around `f` of the given tolerance: the velocity of its low corner, and as limits
/// what the velocity of its high corner leaves of f3 and Delta2. What this task admits of such a
/// box, the pulse does as well. Both velocities are taken to the safe side by a relative `slack`.
[[nodiscard]] FreeTask task_of_box(const PulseProblem& problem, const Limits& limits, double f,
                                   double tolerance, double slack);

/// The largest f whose box fits below f3 and f_max, each with the velocity of that f. There the
/// strip of Delta is widest and the peak least.
[[nodiscard]] double highest_f(const PulseProblem& problem, const Limits& limits);

/// That f and the largest Delta whose box fits below Delta2 and delta_max.
[[nodiscard]] DesignPoint corner_point(const PulseProblem& problem, const Limits& limits);

/// Whether any (f, Delta) is admissible with its box: then that corner is.
[[nodiscard]] bool feasible(const PulseProblem& problem, const Limits& limits);

[[nodiscard]] bool admissible(const PulseProblem& problem, const Limits& limits, double f,
                              double delta);
/// The largest tolerance that an admissible point withstands; empty for one that is not.
[[nodiscard]] std::optional<double> largest_tolerance(const PulseProblem& problem,
                                                      const Limits& limits, double f, double delta);

}  // namespace stillpoint::design
