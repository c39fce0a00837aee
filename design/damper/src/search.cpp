// SPDX-License-Identifier: MIT
#include "nlopt_fence.hpp"
#include "region_edges.hpp"
#include "search_space.hpp"
#include "settle.hpp"

#include <stillpoint/core/input_error.hpp>
#include <stillpoint/design/search.hpp>
#include <stillpoint/design/unit_problem.hpp>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cassert>
#include <chrono>
#include <cmath>
#include <functional>
#include <vector>

namespace stillpoint::design {

namespace {

/// The best point seen, judged by our own constraints: NLopt's last point may be neither feasible
/// nor its best.
class Best {
 public:
  Best(const Problem& problem, const Limits& limits, Objective objective, DesignInterval interval)
      : problem_(problem), limits_(limits), objective_(objective), interval_(interval) {}

  /// Ranks by (admissible, cost), with f moved into the interval and the best Delta for it.
  void consider(double f) {
    if (std::isnan(f)) {
      return;  // SLSQP's answer where its subproblem is degenerate
    }
    const double inside = std::clamp(f, interval_.low, interval_.high);
    const DesignPoint point = with_best_delta(problem_, limits_, inside);
    const double cost = objective_ == Objective::robust
                            ? -point.tolerance
                            : objective_value(objective_, inside / problem_.p / problem_.v0);
    const bool fits = admissible(problem_, limits_, point.f, point.delta);
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
  Problem problem_;
  Limits limits_;
  Objective objective_;
  DesignInterval interval_;
  bool any_{false};
  bool fits_{false};
  double cost_{0};
  DesignPoint point_;
};

NloptAlgorithm find_algorithm(const std::string& wanted) {
  const auto& list = nlopt_algorithms();
  if (wanted.empty()) {
    return list.front();
  }
  const auto found = std::ranges::find(list, wanted, &NloptAlgorithm::name);
  if (found == list.end()) {
    throw InputError("algorithm", wanted,
                     fmt::format("must be one of {}", fmt::join(algorithm_names(), ", ")));
  }
  return *found;
}

/// A global algorithm finds the place of the optimum, not its value: after 20,000 points DIRECT_L
/// is 1e-5 off. A local algorithm gets the last fifth of the budget and starts at the best point.
constexpr double polished_share = 0.2;

NloptOutcome run(const NloptProblem& posed, std::string_view algorithm,
                 const SearchOptions& options,
                 const std::function<Eigen::Vector2d()>& best_so_far) {
  const bool is_global = algorithm.starts_with("GN_") && options.max_evaluations > 1;
  if (!is_global) {
    return minimise(posed, algorithm, {options.max_evaluations, options.max_seconds});
  }
  const int polish = std::max(1, static_cast<int>(polished_share * options.max_evaluations));
  NloptOutcome outcome =
      minimise(posed, algorithm,
               {options.max_evaluations - polish, (1 - polished_share) * options.max_seconds});
  NloptProblem nearby = posed;
  nearby.start = best_so_far();
  const NloptOutcome polished =
      minimise(nearby, "LN_SBPLX", {polish, polished_share * options.max_seconds});
  outcome.x = polished.x;
  outcome.evaluations += polished.evaluations;
  return outcome;
}

}  // namespace

std::string_view name(Objective objective) noexcept {
  switch (objective) {
    case Objective::robust:
      return "robust";
    case Objective::amplitude:
      return "amplitude";
    case Objective::time:
      return "time";
    case Objective::acceleration:
      return "acceleration";
  }
  assert(false && "an Objective outside its enumeration");
  return "";
}

std::span<const std::string_view> algorithm_names() {
  static const std::vector<std::string_view> names = [] {
    std::vector<std::string_view> list;
    for (const NloptAlgorithm& algorithm : nlopt_algorithms()) {
      list.push_back(algorithm.name);
    }
    return list;
  }();
  return names;
}

void require_valid(const SearchOptions& options) {
  static_cast<void>(find_algorithm(options.algorithm));
  if (options.max_evaluations < 1) {
    throw InputError("max_evaluations", options.max_evaluations, "must be at least 1");
  }
  if (!(options.max_seconds > 0)) {
    throw InputError("max_seconds", options.max_seconds, "must be greater than 0");
  }
}

std::optional<SearchResult> search(const Problem& problem, const Limits& limits,
                                   const SearchOptions& options) {
  const auto started = std::chrono::steady_clock::now();
  require_valid(options);
  const Region region = admissible_region(problem, limits);
  if (!region.feasible) {
    return std::nullopt;
  }
  const NloptAlgorithm algorithm = find_algorithm(options.algorithm);
  const Edges edge = edges(problem, limits);
  const DesignInterval interval = design_interval(problem, region);
  Best best(problem, limits, options.objective, interval);

  SearchSpace space;
  space.criterion = problem.criterion;
  space.objective = options.objective;
  space.tolerance = limits.tolerance;
  space.a2 = edge.f2 / problem.p / problem.v0;
  space.a_cap = std::min(edge.f_cap / problem.p / problem.v0, unit::a3);
  space.d_cap = edge.delta_cap / problem.v0 / problem.v0;
  space.visit = [&](double x, double /*y*/) { best.consider(x * edge.f_cap); };

  // Not the middle: where f alone binds, that is the answer of `robust`, and SLSQP ends there in
  // roundoff instead of convergence.
  constexpr double start_fraction = 0.4;
  const double start_f = interval.low + start_fraction * (interval.high - interval.low);
  const DesignPoint start = with_best_delta(problem, limits, start_f);
  const double x = start.f / edge.f_cap;
  const double y = start.delta / edge.delta_cap;
  const auto tolerance_at = [&](double at_x, double at_y) {
    return largest_tolerance(problem, limits, at_x * edge.f_cap, at_y * edge.delta_cap).value_or(0);
  };
  const NloptProblem posed = algorithm.constraints == ConstraintSupport::yes
                                 ? constrained(space, x, y)
                                 : penalised(space, x, y, tolerance_at);
  const NloptOutcome outcome = run(posed, algorithm.name, options, [&] {
    return Eigen::Vector2d(best.point().f / edge.f_cap, best.point().delta / edge.delta_cap);
  });
  best.consider(outcome.x[0] * edge.f_cap);
  // Where an objective is flat to rounding, NLopt stops anywhere. A monotone objective is best at
  // the ends of the interval, and a degenerate region consists of its ends.
  best.consider(interval.low);
  best.consider(interval.high);
  // Where the strip of Delta is so thin that NLopt's steps do not resolve it, `robust` is best
  // where the room below f_cap is as wide as the strip.
  const double floor = delta1(problem, interval.high);
  best.consider(interval.high / (1 + (edge.delta_cap - floor) / (edge.delta_cap + floor)));
  DesignPoint point = best.point();
  if (!best.admissible_found()) {
    // A region that barely allows the tolerance has one design, in the corner of the caps.
    point.f = highest_centre(edge.f_cap, limits.tolerance);
    point.delta = highest_centre(edge.delta_cap, limits.tolerance);
    if (!admissible(problem, limits, point.f, point.delta)) {
      return std::nullopt;
    }
    point.tolerance = largest_tolerance(problem, limits, point.f, point.delta).value_or(0);
  }
  const std::chrono::duration<double> elapsed = std::chrono::steady_clock::now() - started;
  return SearchResult{
      point, {std::string(algorithm.name), outcome.status, outcome.evaluations, elapsed.count()}};
}

}  // namespace stillpoint::design
