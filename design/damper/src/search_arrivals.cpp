// SPDX-License-Identifier: MIT
// The best damper of several strips. Between two strips the mass rests off centre, so a box lies in
// one of them, and the best of all is the best of one: docs/theory.md section 12.

#include "search_run.hpp"
#include "search_space.hpp"
#include "strip.hpp"
#include "strip_space.hpp"

#include <stillpoint/core/input_error.hpp>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <numbers>
#include <span>

namespace stillpoint::design {

namespace {

/// As far as a design stays inside of its edges, a later arrival is no better than an earlier one.
constexpr double better_by = 1e-8;

/// What the objective minimises, comparable between strips: -R, or of order one.
double cost_of(const Problem& problem, Objective objective, const DesignPoint& point, int n) {
  if (objective == Objective::robust) {
    return -point.tolerance;
  }
  const StripTask task(problem, {}, n);
  const double a = task.scaled(point.f);
  if (objective != Objective::time) {
    return objective_value(objective, a);
  }
  return n == 1 ? objective_value(objective, a)
                : n * strip_cost(task, objective, a, point.delta / problem.v0 / problem.v0);
}

/// No damper of the strip costs less. In the same units.
double least_cost(const StripTask& task, Objective objective) {
  const double tolerance = task.limits.tolerance;
  switch (objective) {
    case Objective::robust:
      return -1.0 / (2 * task.n - 1);  // (51)
    case Objective::amplitude:
      return objective_value(objective, task.a_cap / (1 + tolerance));
    case Objective::time:
      return task.n;  // (52): a half-cycle takes at least pi
    case Objective::acceleration:
      return objective_value(objective, std::max(0.0, task.a2) / (1 - tolerance));
  }
  return 0;
}

struct Winner {
  SearchResult found;
  double cost{0};
};

/// The best point of one strip; empty if that is empty or narrower than rounding.
std::optional<SearchResult> search_strip(const StripTask& task, const SearchOptions& options) {
  const auto started = std::chrono::steady_clock::now();
  const auto interval = design_f(task);
  if (!interval) {
    return std::nullopt;
  }
  const auto known = any_point(task);
  if (!known) {
    return std::nullopt;
  }
  constexpr double start_fraction = 0.4;  // as in search.cpp
  const Objective objective = options.objective;
  const bool by_time = objective == Objective::time;
  const auto at = [&](double f) {
    return with_best_delta(task, std::clamp(f, interval->low, interval->high), by_time);
  };
  const DesignPoint middle =
      with_best_delta(task, interval->low + start_fraction * (interval->high - interval->low));
  const NloptAlgorithm algorithm = find_algorithm(options.algorithm);
  Tried tried{{}, HUGE_VAL, Eigen::Vector2d(task.scaled(middle.f) / task.a_cap, 0.5)};
  const NloptProblem posed = strip_posed(algorithm.constraints, task, objective, middle, tried);
  const NloptOutcome outcome = run(posed, algorithm.name, options, [&] { return tried.best; });

  std::optional<Winner> best;
  const auto consider = [&](const DesignPoint& point) {
    if (!admissible(task, point.f, point.delta)) {
      return;
    }
    const double cost = cost_of(task.problem, objective, point, task.n);
    if (!best || cost < best->cost) {
      best = {{point, {}}, cost};
    }
  };
  if (!std::isnan(outcome.x[0])) {
    consider(at(task.f_of(outcome.x[0] * task.a_cap)));
  }
  consider(at(task.f_of(tried.best[0] * task.a_cap)));
  // NLopt returns the best point that met all constraints to the last bit, which may be its start;
  // the last ones that it tried are those that it came to.
  constexpr std::size_t last = 3;
  for (const double x : std::span(tried.x).last(std::min(last, tried.x.size()))) {
    if (!std::isnan(x)) {
      consider(at(task.f_of(x * task.a_cap)));
    }
  }
  // The points that NLopt may miss: where an objective is flat, or the strip very thin.
  consider(at(interval->low));
  consider(at(interval->high));
  consider({known->f, known->delta, largest_tolerance(task, known->f, known->delta).value_or(0)});
  const std::chrono::duration<double> elapsed = std::chrono::steady_clock::now() - started;
  best->found.record = {std::string(algorithm.name), outcome.status, outcome.evaluations,
                        elapsed.count()};
  return best->found;
}

}  // namespace

std::optional<SearchResult> search_arrivals(const Problem& problem, const Limits& limits,
                                            const SearchOptions& options) {
  require_valid(problem, limits);
  std::optional<Winner> best;
  if (const auto first = search(with_one_arrival(problem), limits, options)) {
    best = {*first, cost_of(problem, options.objective, first->point, 1)};
  }
  SearchRecord all = best ? best->found.record : SearchRecord{};
  for_each_strip(problem, limits, [&](const StripTask& task) {
    if (best && least_cost(task, options.objective) >= best->cost - better_by) {
      return false;  // nor is any later one better
    }
    if (const auto found = search_strip(task, options)) {
      all.evaluations += found->record.evaluations;
      all.wall_time_s += found->record.wall_time_s;
      const double cost = cost_of(problem, options.objective, found->point, task.n);
      if (!best || cost < best->cost - better_by) {
        best = {*found, cost};
      }
    }
    return true;
  });
  if (!best) {
    return std::nullopt;
  }
  best->found.record.evaluations = all.evaluations;
  best->found.record.wall_time_s = all.wall_time_s;
  return best->found;
}

}  // namespace stillpoint::design
