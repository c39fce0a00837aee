// SPDX-License-Identifier: MIT
// The best damper of several ways to come to rest. Between two of them some rest is too far off
// centre, so a box lies in one of them, and the best of all is the best of one: docs/theory.md
// section 13.

#include "search_run.hpp"
#include "search_space.hpp"
#include "way_space.hpp"

#include <algorithm>
#include <array>
#include <chrono>
#include <cmath>
#include <limits>
#include <span>

namespace stillpoint::design {

namespace {

/// As far as a design stays inside of its edges, a later way is no better than an earlier one.
constexpr double clearly_better = 1e-8;

/// No damper of the way costs less, as way_cost.
double bound_of(const Way& way, Objective objective) {
  const double t = way.limits.tolerance;
  const auto& [f_low, f_high, delta_low, delta_high] = way.limits.shape;
  switch (objective) {
    case Objective::robust:
      // (51), which a range only makes smaller.
      return way.q == 0 && way.limits.shape == BoxShape{} ? -1.0 / (2 * way.n - 1) : -1;
    case Objective::amplitude:
      return objective_value(objective, way.a_cap / (1 + t * f_high));
    case Objective::acceleration:
      return objective_value(objective, std::max(0.0, way.a2) / (1 - t * f_low));
    case Objective::time:
      return way.q == 0 ? way.n : 0;
  }
  return 0;
}

struct WayBest {
  std::optional<DesignPoint> point;
  double cost{HUGE_VAL};

  void consider(const Way& way, Objective objective, const DesignPoint& candidate) {
    if (admissible(way, candidate.f, candidate.delta)) {
      const double its = way_cost(way, objective, candidate);
      if (its < cost) {
        point = candidate;
        cost = its;
      }
    }
  }
};

/// Where to begin: any f, or for `time` the best of a grid, because the stop time jumps where the
/// number of half-cycles does.
DesignPoint start_of(const Way& way, Objective objective, const WayPoint& inside) {
  WayBest best;
  best.consider(way, objective,
                {inside.f, inside.delta, largest_tolerance(way, inside.f, inside.delta).value()});
  best.consider(way, objective, with_best_delta(way, inside.f));
  if (objective == Objective::time) {
    const unit::Ends ends = feasible_f(way).value_or(unit::Ends{inside.f, inside.f});
    constexpr int steps = 16;
    for (int i = 0; i <= steps; ++i) {
      const double f = std::max(ends.low + (ends.high - ends.low) * i / steps, inside.f * 1e-6);
      for (const BestDelta choice : {BestDelta::least, BestDelta::middle, BestDelta::largest}) {
        best.consider(way, objective, with_best_delta(way, f, choice));
      }
    }
  }
  return *best.point;
}

struct WayResult {
  DesignPoint point;
  double cost;
  NloptOutcome outcome;
};

std::optional<WayResult> search_way(const Way& way, const SearchOptions& options) {
  const auto inside = any_point(way);
  if (!inside) {
    return std::nullopt;
  }
  const Objective objective = options.objective;
  const NloptAlgorithm algorithm = find_algorithm(options.algorithm);
  const DesignPoint start = start_of(way, objective, *inside);
  Tried tried{{}, HUGE_VAL, Eigen::Vector2d(way.scaled(start.f) / way.a_cap, 0.5)};
  const NloptProblem posed = way_posed(algorithm.constraints, way, objective, start, tried);
  NloptOutcome outcome = run(posed, algorithm.name, options, [&] { return tried.best; });

  WayBest best;
  best.consider(way, objective, start);
  const auto consider = [&](double x) {
    if (std::isnan(x) || !(x > 0)) {
      return;
    }
    const double f = std::min(way.f_of(x * way.a_cap), way.f_cap);
    best.consider(way, objective, with_best_delta(way, f));
    if (objective == Objective::time) {
      best.consider(way, objective, with_best_delta(way, f, BestDelta::least));
      best.consider(way, objective, with_best_delta(way, f, BestDelta::largest));
    }
  };
  consider(outcome.x[0]);
  if (algorithm.constraints == ConstraintSupport::no) {
    consider(tried.best[0]);
  }
  // As in search_arrivals.cpp.
  constexpr std::size_t last = 3;
  for (const double x : std::span(tried.x).last(std::min(last, tried.x.size()))) {
    consider(x);
  }
  if (objective != Objective::robust) {
    const unit::Ends ends = feasible_f(way).value_or(unit::Ends{inside->f, inside->f});
    constexpr double inset = 1e-9;  // as in settle.hpp
    const double least = std::max(ends.low * (1 + inset),
                                  std::min(inside->f, inset * way.problem.v0 * way.problem.p));
    consider(way.scaled(std::min(least, ends.high)) / way.a_cap);
    consider(way.scaled(std::max(ends.high * (1 - inset), ends.low)) / way.a_cap);
    consider(way.scaled(ends.high) / way.a_cap);
    consider(way.scaled(inside->f) / way.a_cap);
  }
  return WayResult{*best.point, best.cost, std::move(outcome)};
}

}  // namespace

std::optional<SearchResult> search_ways(const Problem& problem, const Limits& limits,
                                        const SearchOptions& options) {
  const auto started = std::chrono::steady_clock::now();
  require_valid(problem, limits);
  require_valid(options);
  std::optional<WayResult> best;
  int evaluations = 0;
  for_each_way(problem, limits, [&](const Way& way) {
    if (best && bound_of(way, options.objective) >= best->cost - clearly_better) {
      return true;
    }
    if (auto found = search_way(way, options)) {
      evaluations += found->outcome.evaluations;
      if (!best || found->cost < best->cost - clearly_better) {
        best = std::move(found);
      }
    }
    return true;
  });
  if (!best) {
    return std::nullopt;
  }
  const std::chrono::duration<double> elapsed = std::chrono::steady_clock::now() - started;
  return SearchResult{best->point,
                      {std::string(find_algorithm(options.algorithm).name), best->outcome.status,
                       evaluations, elapsed.count()}};
}

}  // namespace stillpoint::design
