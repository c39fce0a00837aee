// SPDX-License-Identifier: MIT
#pragma once

// The admissible region where a pulse leaves the initial velocity V(f), docs/theory.md section 8.
// V falls with f, so the box f (1 +- R) is tightest where the free one is, at its two corners, with
// the velocity of either. Both corners must hold under the pulse itself too.

#include <stillpoint/design/problem.hpp>
#include <stillpoint/design/pulse.hpp>
#include <stillpoint/design/region.hpp>
#include <stillpoint/design/search.hpp>

#include <optional>
#include <vector>

namespace stillpoint::design {

/// The task of a design for a pulse.
struct PulseTask {
  PulseTask(const PulseProblem& what, const Limits& allowed);

  PulseProblem problem;
  Limits limits;
  /// The largest f under which the mass comes back to x = 0 after the pulse itself: the f3 of the
  /// forced motion, which lies a little below that of V(f).
  double f_most;
};

/// A problem and limits of constant velocity.
struct FreeTask {
  Problem problem;
  Limits limits;
};

/// For the box around `f` with the given tolerance: the velocity of its low corner and, as limits,
/// f3 and Delta2 for the velocity of its high corner, and f_most. If this task admits such a box,
/// so does the pulse. Both velocities and f_most are moved to the safe side by a relative `slack`.
[[nodiscard]] FreeTask task_of_box(const PulseTask& task, double f, double tolerance, double slack);

/// The largest f whose box fits below f3, f_most and f_max, f3 with the velocity of that f. There
/// the strip of Delta is widest and the peak least.
[[nodiscard]] double highest_f(const PulseTask& task);

/// The smallest f that has any Delta. For a feasible task.
[[nodiscard]] double lowest_f(const PulseTask& task);

/// The highest f and the largest Delta whose box fits below Delta2 and delta_max.
[[nodiscard]] DesignPoint corner_point(const PulseTask& task);

/// Whether any (f, Delta) is admissible with its box: then that corner is.
[[nodiscard]] bool feasible(const PulseTask& task);

[[nodiscard]] bool admissible(const PulseTask& task, double f, double delta);
/// The largest tolerance of an admissible point; empty for any other point.
[[nodiscard]] std::optional<double> largest_tolerance(const PulseTask& task, double f,
                                                      double delta);

/// Like mends() of region.hpp, with k and lambda instead of v0.
[[nodiscard]] std::vector<Mend> mends(const PulseProblem& problem, const Limits& limits);
[[nodiscard]] std::optional<JointMend> joint_mend(const PulseProblem& problem,
                                                  const Limits& limits);

}  // namespace stillpoint::design
