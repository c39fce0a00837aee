// SPDX-License-Identifier: MIT
#include "pulse_region.hpp"

#include "nearest_fit.hpp"
#include "region_edges.hpp"

#include <stillpoint/core/forced_motion.hpp>
#include <stillpoint/design/region.hpp>

#include <algorithm>
#include <cassert>
#include <cmath>

namespace stillpoint::design {

namespace {

/// The motion under the pulse itself comes back to x = 0, rests there and has stayed within beta.
bool holds_under_pulse(const PulseProblem& problem, double f, double delta) {
  const ForcedResponse motion =
      forced_response({problem.p, f, delta}, {}, excitation(problem.pulse));
  return motion.stops_at_zero && motion.half_cycles == 1.0 && motion.peak_amplitude <= problem.beta;
}

double last_f_that_returns(PulseProblem problem) {
  problem.beta = HUGE_VAL;
  const double v0 = problem_at(problem, 0).v0;
  // Four times what holds the mass at its first return, so that this asks for the return alone.
  const double delta = 2 * v0 * v0;
  const auto last = nearest_fit(peak_load(problem.pulse), 0,
                                [&](double f) { return holds_under_pulse(problem, f, delta); });
  assert(last && "without friction the mass comes back");
  return *last;
}

/// The largest Delta whose box fits below the caps for a box around f.
double highest_delta(const PulseTask& task, double f) {
  const double tolerance = task.limits.tolerance;
  return highest_centre(*task_of_box(task, f, tolerance, 0).limits.delta_max, tolerance);
}

}  // namespace

PulseTask::PulseTask(const PulseProblem& what, const Limits& allowed)
    : problem(what), limits(allowed), f_most(last_f_that_returns(what)) {}

FreeTask task_of_box(const PulseTask& task, double f, double tolerance, double slack) {
  const auto& [problem, limits, f_most] = task;
  Problem at_high = problem_at(problem, f * (1 + tolerance));
  at_high.v0 *= 1 - slack;
  const Edges edge = edges(at_high, limits);
  FreeTask free{problem_at(problem, f * (1 - tolerance)), limits};
  free.problem.v0 *= 1 + slack;
  free.limits.f_max = std::min(edge.f_cap, f_most * (1 - slack));
  free.limits.delta_max = edge.delta_cap;
  return free;
}

double highest_f(const PulseTask& task) {
  const auto returns = [&](double f) {
    const Problem now = problem_at(task.problem, f);
    return now.v0 > 0 && f <= edges(now, task.limits).f_cap;
  };
  return highest_centre(*nearest_fit(task.f_most, 0, returns), task.limits.tolerance);
}

double lowest_f(const PulseTask& task) {
  return *nearest_fit(0, highest_f(task), [&](double f) {
    return f > 0 && admissible(task, f, highest_delta(task, f));
  });
}

DesignPoint corner_point(const PulseTask& task) {
  const double f = highest_f(task);
  return {f, highest_delta(task, f), task.limits.tolerance};
}

bool feasible(const PulseTask& task) {
  const DesignPoint corner = corner_point(task);
  return admissible(task, corner.f, corner.delta);
}

bool admissible(const PulseTask& task, double f, double delta) {
  const auto& [problem, limits, f_most] = task;
  const double low = f * (1 - limits.tolerance);
  const double high = f * (1 + limits.tolerance);
  const double low_delta = delta * (1 - limits.tolerance);
  return high <= f_most &&
         box_admissible(problem_at(problem, low), problem_at(problem, high), limits, f, delta) &&
         holds_under_pulse(problem, low, low_delta) && holds_under_pulse(problem, high, low_delta);
}

std::optional<double> largest_tolerance(const PulseTask& task, double f, double delta) {
  PulseTask box = task;
  const auto fits = [&](double tolerance) {
    box.limits.tolerance = tolerance;
    return admissible(box, f, delta);
  };
  return nearest_fit(std::nextafter(1.0, 0.0), 0, fits);
}

}  // namespace stillpoint::design
