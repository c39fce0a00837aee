// SPDX-License-Identifier: MIT
#pragma once

// The strip of the n-th arrival of a task, n >= 2, with its limits: docs/theory.md section 12.

#include "region_edges.hpp"
#include "unit_strip.hpp"

#include <stillpoint/design/problem.hpp>
#include <stillpoint/design/search.hpp>

#include <optional>

namespace stillpoint::design {

/// The task of the motion shown alone, by the model itself.
[[nodiscard]] Problem strongest_hit(Problem problem);

/// The paper's task: to stop at the first arrival.
[[nodiscard]] Problem with_one_arrival(Problem problem);

/// The least doubles V0 for which the damper reaches the n-th arrival and passes it, (46).
struct PassingSpeeds {
  double reach;
  double pass;
};
[[nodiscard]] PassingSpeeds passing_speeds(const Problem& problem, int n, double f, double delta);

/// The arrival that decides about a damper: that at which it stops the mass, or else the first one
/// that the mass does not reach, or the last one allowed if it passes all.
struct DecidingArrival {
  int n;
  bool stops;
};
[[nodiscard]] DecidingArrival deciding_arrival(const Problem& problem, double f, double delta);

/// One arrival of the task, in the units of unit_problem.hpp.
struct StripTask {
  StripTask(const Problem& what, const Limits& allowed, int arrival);

  Problem problem;
  Limits limits;
  int n;
  Edges edge;
  double a2;
  double a_cap;  ///< of the limits and of the strip's tip
  double d_cap;  ///< of delta_max; infinite without

  [[nodiscard]] double scaled(double f) const { return f / problem.p / problem.v0; }
  [[nodiscard]] double f_of(double a) const { return a * problem.v0 * problem.p; }
};

/// Every f (1 +- R), delta (1 +- R) is in the strip and within beta and the limits.
[[nodiscard]] bool admissible(const StripTask& task, double f, double delta);
/// The largest R of the point; empty if it is not admissible itself.
[[nodiscard]] std::optional<double> largest_tolerance(const StripTask& task, double f,
                                                      double delta);

/// The f of the centres of all boxes that fit, (50); a lower end of 0 is open.
[[nodiscard]] std::optional<unit::Ends> feasible_f(const StripTask& task);
/// The same for a design: a relative 1e-9 inside, as in settle.hpp.
[[nodiscard]] std::optional<unit::Ends> design_f(const StripTask& task);

/// The Delta that goes best with an f: the one with the most tolerance, or the least one if
/// `least`.
[[nodiscard]] DesignPoint with_best_delta(const StripTask& task, double f, bool least = false);

/// An admissible point, wherever there is one.
struct StripPoint {
  double f;
  double delta;
};
[[nodiscard]] std::optional<StripPoint> any_point(const StripTask& task);
/// The largest tolerance of any point, by bisection of any_point.
[[nodiscard]] double largest_tolerance(const StripTask& task);

/// Calls `visit` with the task of each arrival from the second on that may have a strip, until it
/// returns false: with too small a beta or too large a tolerance no later one has.
template <class Visit>
void for_each_strip(const Problem& problem, const Limits& limits, const Visit& visit) {
  constexpr double rounding = 1e-12;
  const double b = problem.beta * problem.p / problem.v0;
  for (int n = 2; n <= problem.arrivals; ++n) {
    if (b * b * (n + 1) < n * (1 - rounding) || limits.tolerance * (2 * n - 1) > 1 + rounding ||
        !visit(StripTask(problem, limits, n))) {
      return;
    }
  }
}

}  // namespace stillpoint::design
