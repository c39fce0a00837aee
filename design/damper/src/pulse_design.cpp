// SPDX-License-Identifier: MIT
#include "finding.hpp"
#include "pulse_region.hpp"
#include "settle.hpp"

#include <stillpoint/design/cross_check.hpp>
#include <stillpoint/design/design.hpp>

#include <boost/math/tools/minima.hpp>

#include <algorithm>
#include <cassert>
#include <cmath>
#include <limits>

namespace stillpoint::design {

namespace {

/// A point that is admissible for the pulse, with the cost that ranks it.
struct Candidate {
  DesignPoint point;
  double cost{0};
};

double cost_of(Objective objective, const PulseProblem& problem, const DesignPoint& point) {
  if (objective == Objective::robust) {
    return -point.tolerance;
  }
  const Prediction motion = predict(problem_at(problem, point.f), point.f);
  return objective == Objective::amplitude ? motion.peak_amplitude
         : objective == Objective::time    ? motion.stop_time
                                           : motion.peak_acceleration;
}

/// The task of the search and its options.
struct Hunt {
  PulseTask task;
  SearchOptions options;
};

/// The better of `best` and the point, judged over its whole box with V(f) and under the pulse.
void consider(std::optional<Candidate>& best, const Hunt& hunt, DesignPoint point) {
  const auto& [task, options] = hunt;
  if (!admissible(task, point.f, point.delta)) {
    return;
  }
  point.tolerance = largest_tolerance(task, point.f, point.delta).value_or(0);
  const double cost = cost_of(options.objective, task.problem, point);
  if (!best || cost < best->cost) {
    best = {point, cost};
  }
}

/// The same with the best Delta for f.
void consider_f(std::optional<Candidate>& best, const Hunt& hunt, double f) {
  const FreeTask free = task_of_box(hunt.task, f, hunt.task.limits.tolerance, 0);
  consider(best, hunt, with_best_delta(free.problem, free.limits, f));
}

/// The next argument on the way to x = g(x), by Wegstein's method: the secant through the last two
/// rounds. Held to steps that neither overshoot nor stand still.
class FixedPoint {
 public:
  explicit FixedPoint(double x) : x_(x) {}

  [[nodiscard]] double x() const { return x_; }
  void answer(double g) {
    // A step of less would stall where the secant misjudges the slope.
    constexpr double shortest = 0.05;
    const double slope = x_ != x_before_ ? (g - g_before_) / (x_ - x_before_) : 0;
    const double part = std::clamp(slope < 1 ? 1 / (1 - slope) : 1, shortest, 1.0);
    x_before_ = x_;
    g_before_ = g;
    x_ += part * (g - x_);
  }
  /// Where g has no answer: half way back.
  void retreat() { x_ = x_before_ + (x_ - x_before_) / 2; }

 private:
  double x_;
  double x_before_{x_};
  double g_before_{0};
};

/// Where S = sqrt(f^2 + (V(f) p)^2) is least: V falls with f, so that is not the lowest f.
double softest_f(const PulseProblem& problem, double low, double high) {
  const auto acceleration = [&](double f) {
    return std::hypot(f, problem_at(problem, f).v0 * problem.p);
  };
  // A minimum has only half of the digits.
  constexpr int bits = std::numeric_limits<double>::digits / 2;
  return boost::math::tools::brent_find_minima(acceleration, low, high, bits).first;
}

/// Rounds of the search with the velocities of the box last found, until that does not move. At
/// that point the constraints that bind are those of the pulse itself.
SearchResult search(const Hunt& hunt) {
  const auto& [task, options] = hunt;
  const Limits& limits = task.limits;
  constexpr int most_rounds = 60;    // some five are taken; a round is a search of 20 us
  constexpr double settled = 1e-10;  // relative, of f and of 1: what NLopt's tolerance resolves
  constexpr double slack = 1e-9;     // more than that, so that the settled point is admissible
  const DesignPoint corner = corner_point(task);
  std::optional<Candidate> best;
  SearchRecord record;
  FixedPoint f(corner.f);
  FixedPoint tolerance(limits.tolerance);
  for (int round = 0; round < most_rounds; ++round) {
    const FreeTask free = task_of_box(task, f.x(), tolerance.x(), slack);
    const auto found = search(free.problem, free.limits, options);
    if (!found) {
      f.retreat();
      tolerance.retreat();
      continue;
    }
    const auto& [point, last] = *found;
    record = {last.algorithm, last.status, record.evaluations + last.evaluations,
              record.wall_time_s + last.wall_time_s};
    const double wider =
        options.objective == Objective::robust ? point.tolerance : limits.tolerance;
    const double change = std::max(std::abs(point.f / f.x() - 1), std::abs(wider - tolerance.x()));
    f.answer(point.f);
    tolerance.answer(wider);
    consider(best, hunt, point);
    if (change <= settled) {
      break;
    }
  }
  if (options.objective == Objective::acceleration) {
    const double inside = corner.f * (1 - slack);
    consider_f(best, hunt, softest_f(task.problem, std::min(f.x(), inside), inside));
  }
  if (!best) {
    // The region is too small for NLopt's steps.
    consider_f(best, hunt, corner.f);
    consider(best, hunt, corner);
  }
  assert(best);
  return SearchResult{best->point, record};
}

/// Where the limits come from the velocity of the high corner, the conflict is with the edge behind
/// them.
Conflict as_asked(Conflict conflict, const FreeTask& task, const Limits& limits) {
  if (conflict == Conflict::amplitude_against_f_max && task.limits.f_max != limits.f_max) {
    return Conflict::amplitude_against_return;
  }
  if (conflict == Conflict::stop_against_delta_max && task.limits.delta_max != limits.delta_max) {
    return Conflict::stop_against_start;
  }
  return conflict;
}

/// The empty region, told for the largest f.
DesignResult without_design(const PulseTask& task, const SearchOptions& options) {
  const Limits& limits = task.limits;
  const FreeTask free = task_of_box(task, highest_f(task), limits.tolerance, 0);
  DesignResult result{{admissible_region(free.problem, free.limits)},
                      {free.problem, limits, options, task.problem.pulse}};
  result.region.conflict = result.region.feasible ? Conflict::narrower_than_rounding
                                                  : as_asked(result.region.conflict, free, limits);
  result.region.feasible = false;
  result.region.f_lower = result.region.f_upper = std::nullopt;
  result.region.f3 = std::min(result.region.f3, *free.limits.f_max);
  result.reason = reason(result.region, free.problem, free.limits);
  result.mends = mends(task.problem, limits);
  result.joint_mend = joint_mend(task.problem, limits);
  return result;
}

/// The paper's edges with the velocity at f; the interval of f is that of the pulse.
Region region_at(const PulseTask& task, const Problem& reduced) {
  Region region = admissible_region(reduced, task.limits);
  region.feasible = true;
  region.conflict = Conflict::none;
  region.f_lower = lowest_f(task);
  region.f_upper = highest_f(task);
  return region;
}

}  // namespace

DesignResult design(const PulseRequest& request) {
  const auto& [problem, limits, options] = request;
  require_valid(options);
  require_valid(problem, limits);
  const PulseTask task(problem, limits);
  if (!feasible(task)) {
    return without_design(task, options);
  }
  const SearchResult found = search({task, options});
  const Problem reduced = problem_at(problem, found.point.f);
  DesignResult result{{region_at(task, reduced)}, {reduced, limits, options, problem.pulse}};
  result.finding = finding_of(reduced, limits, found);
  result.finding->pulse = check_under_pulse(problem, *result.finding);
  return result;
}

}  // namespace stillpoint::design
