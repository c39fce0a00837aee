// SPDX-License-Identifier: MIT
#include "region_edges.hpp"
#include "search_run.hpp"
#include "search_space.hpp"
#include "settle.hpp"
#include "unit_problem.hpp"

#include <stillpoint/design/search.hpp>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <optional>
#include <vector>

namespace stillpoint::design {

namespace {

/// What is searched.
struct Task {
  const Problem& problem;
  const Limits& limits;
  Objective objective;
  Edges edge;
  DesignInterval interval;

  /// f in the units of the closed forms.
  [[nodiscard]] double scaled(double f) const { return f / problem.p / problem.v0; }
};

/// The best point seen, judged by our own constraints: NLopt's last point may be neither feasible
/// nor its best.
class Best {
 public:
  explicit Best(const Task& task) : task_(task) {}

  /// Ranks by (admissible, cost), with f moved into the interval and the best Delta for it.
  void consider(double f) {
    if (std::isnan(f)) {
      return;  // SLSQP's answer where its subproblem is degenerate
    }
    const double inside = std::clamp(f, task_.interval.low, task_.interval.high);
    const DesignPoint point = with_best_delta(task_.problem, task_.limits, inside);
    const double cost = task_.objective == Objective::robust
                            ? -point.tolerance
                            : objective_value(task_.objective, task_.scaled(inside));
    const bool fits = admissible(task_.problem, task_.limits, point.f, point.delta);
    if (!any_ || (fits && !fits_) || (fits == fits_ && cost < cost_)) {
      any_ = true;
      fits_ = fits;
      cost_ = cost;
      point_ = point;
    }
  }

  [[nodiscard]] bool admissible_found() const { return fits_; }
  [[nodiscard]] const DesignPoint& point() const { return point_; }

 private:
  const Task& task_;
  bool any_{false};
  bool fits_{false};
  double cost_{0};
  DesignPoint point_;
};

/// The task as NLopt sees it; `best` is told of every f that it tries.
NloptProblem posed_for(ConstraintSupport support, const Task& task, Best& best) {
  const auto& [problem, limits, objective, edge, interval] = task;
  SearchSpace space;
  space.criterion = problem.criterion;
  space.objective = objective;
  space.tolerance = limits.tolerance;
  space.a2 = task.scaled(edge.f2);
  space.a_cap = std::min(task.scaled(edge.f_cap), unit::a3);
  space.d_cap = edge.delta_cap / problem.v0 / problem.v0;
  space.visit = [&](double x, double /*y*/) { best.consider(x * task.edge.f_cap); };

  // Not the middle: where f alone binds, that is the answer of `robust`, and SLSQP ends there in
  // roundoff instead of convergence.
  constexpr double start_fraction = 0.4;
  const double start_f = interval.low + start_fraction * (interval.high - interval.low);
  const DesignPoint start = with_best_delta(problem, limits, start_f);
  const double x = start.f / edge.f_cap;
  const double y = start.delta / edge.delta_cap;
  if (support == ConstraintSupport::yes) {
    return constrained(space, x, y);
  }
  return penalised(space, x, y, [&task](double at_x, double at_y) {
    return largest_tolerance(task.problem, task.limits, at_x * task.edge.f_cap,
                             at_y * task.edge.delta_cap)
        .value_or(0);
  });
}

/// The points that NLopt may miss.
void consider_known_optima(Best& best, const Task& task) {
  const auto& [low, high] = task.interval;
  // Where an objective is flat to rounding NLopt rests anywhere; the ends of the interval are where
  // a monotone one is best, and the region's own are all there is of a degenerate region.
  best.consider(low);
  best.consider(high);
  // Where the strip of Delta is so thin that NLopt's steps do not resolve it, `robust` is best
  // where the room below f_cap is as wide as the strip.
  const double cap = task.edge.delta_cap;
  const double floor = delta1(task.problem, high);
  best.consider(high / (1 + (cap - floor) / (cap + floor)));
}

/// A region that only just allows the tolerance has one design, in the corner of the caps.
std::optional<DesignPoint> corner_point(const Task& task) {
  const auto& [problem, limits, objective, edge, interval] = task;
  const double f = highest_centre(edge.f_cap, limits.tolerance);
  const double delta = highest_centre(edge.delta_cap, limits.tolerance);
  if (!admissible(problem, limits, f, delta)) {
    return std::nullopt;
  }
  return DesignPoint{f, delta, largest_tolerance(problem, limits, f, delta).value_or(0)};
}

}  // namespace

std::optional<SearchResult> search(const Problem& problem, const Limits& limits,
                                   const SearchOptions& options) {
  if (!is_plain(problem, limits)) {
    return search_ways(problem, limits, options);
  }
  if (problem.arrivals > 1) {
    return search_arrivals(problem, limits, options);
  }
  const auto started = std::chrono::steady_clock::now();
  require_valid(options);
  const Region region = admissible_region(problem, limits);
  if (!region.feasible) {
    return std::nullopt;
  }
  const NloptAlgorithm algorithm = find_algorithm(options.algorithm);
  const Task task{problem, limits, options.objective, edges(problem, limits),
                  design_interval(problem, region)};
  Best best(task);
  const NloptProblem posed = posed_for(algorithm.constraints, task, best);
  const NloptOutcome outcome = run(posed, algorithm.name, options, [&] {
    return Eigen::Vector2d(best.point().f / task.edge.f_cap,
                           best.point().delta / task.edge.delta_cap);
  });
  best.consider(outcome.x[0] * task.edge.f_cap);
  consider_known_optima(best, task);
  const std::optional<DesignPoint> point =
      best.admissible_found() ? best.point() : corner_point(task);
  if (!point) {
    return std::nullopt;
  }
  const std::chrono::duration<double> elapsed = std::chrono::steady_clock::now() - started;
  return SearchResult{
      *point, {std::string(algorithm.name), outcome.status, outcome.evaluations, elapsed.count()}};
}

}  // namespace stillpoint::design
