// SPDX-License-Identifier: MIT
#include "pulse_region.hpp"

#include "box.hpp"
#include "nearest_fit.hpp"
#include "region_edges.hpp"

#include <stillpoint/design/region.hpp>

#include <algorithm>
#include <cmath>

namespace stillpoint::design {

FreeTask task_of_box(const PulseProblem& problem, const Limits& limits, double f, double tolerance,
                     double slack) {
  Problem at_high = problem_at(problem, f * (1 + tolerance));
  at_high.v0 *= 1 - slack;
  const Edges edge = edges(at_high, limits);
  FreeTask task{problem_at(problem, f * (1 - tolerance)), limits};
  task.problem.v0 *= 1 + slack;
  task.limits.f_max = edge.f_cap;
  task.limits.delta_max = edge.delta_cap;
  return task;
}

double highest_f(const PulseProblem& problem, const Limits& limits) {
  const double k = peak_load(problem.pulse);
  const auto returns = [&](double f) {
    if (!(f < k)) {
      return false;
    }
    const Problem now = problem_at(problem, f);
    return now.v0 > 0 && f <= edges(now, limits).f_cap;
  };
  return highest_centre(*nearest_fit(k, 0, returns), limits.tolerance);
}

DesignPoint corner_point(const PulseProblem& problem, const Limits& limits) {
  const double f = highest_f(problem, limits);
  const FreeTask task = task_of_box(problem, limits, f, limits.tolerance, 0);
  return {f, highest_centre(*task.limits.delta_max, limits.tolerance), limits.tolerance};
}

bool feasible(const PulseProblem& problem, const Limits& limits) {
  const DesignPoint corner = corner_point(problem, limits);
  return admissible(problem, limits, corner.f, corner.delta);
}

bool admissible(const PulseProblem& problem, const Limits& limits, double f, double delta) {
  const double high = f * (1 + limits.tolerance);
  if (!(high < peak_load(problem.pulse))) {
    return false;
  }
  return box_admissible(problem_at(problem, f * (1 - limits.tolerance)), problem_at(problem, high),
                        limits, f, delta);
}

std::optional<double> largest_tolerance(const PulseProblem& problem, const Limits& limits, double f,
                                        double delta) {
  const auto fits = [&](double tolerance) {
    Limits box = limits;
    box.tolerance = tolerance;
    return admissible(problem, box, f, delta);
  };
  return nearest_fit(std::nextafter(1.0, 0.0), 0, fits);
}

}  // namespace stillpoint::design
