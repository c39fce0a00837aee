// SPDX-License-Identifier: MIT
// The best damper of several ways to come to rest. Between two of them some rest is too far off
// centre, so a box lies in one of them, and the best of all is the best of one: docs/theory.md
// sections 8, 12 and 13.

#include "falling_root.hpp"
#include "search/best_point.hpp"
#include "search/nlopt_fence.hpp"
#include "search/objectives.hpp"
#include "unit_problem.hpp"
#include "way/room.hpp"
#include "way/space.hpp"

#include <stillpoint/core/elementary.hpp>
#include <stillpoint/core/seconds.hpp>
#include <stillpoint/design/search.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <span>
#include <vector>

namespace stillpoint::design {

namespace {

/// No damper of the way costs less, as way_cost.
double bound_of(const Way& way, Objective objective) {
  const double t = way.limits.tolerance;
  const auto& [f_low, f_high, delta_low, delta_high] = way.limits.shape;
  if (objective == Objective::robust) {  // (51), which a range only makes smaller
    return way.q == 0 && way.problem.zeta.high == 0 && way.limits.shape == BoxShape{}
               ? -1.0 / (2 * way.n - 1)
               : -1;
  }
  const double low = std::max(0.0, way.a2) / (1 - t * f_low);
  const double high = way.a_cap / (1 + t * f_high);
  if (objective == Objective::time) {
    // The n-th half-cycle turns or stops at x = 0, which takes pi at least, (52).
    return std::max<double>(way.n, first_half_turn(low, high));
  }
  return objective_value(objective, falls_with_f(objective) ? high : low);
}

/// The dampers that stop the shown motion soonest: at the n-th arrival, with the least Delta of
/// those that stop it there, the time grows with f for n = 1, and else first falls and then grows.
void consider_stops(const Way& way, const Interval& ends, BestPoint& best) {
  const double t = way.limits.tolerance;
  for (int n = 1; n <= way.passages() && n < best.cost(); ++n) {
    const auto largest = [&](double f) {
      const auto d = centre_range(way, f, t);
      return d ? std::max(d->low, d->high * (1 - way_inset)) : -1;
    };
    const auto spare = [&](double f) { return largest(f) - d_that_stops_at(n, way.scaled(f)); };
    const auto consider = [&](double f) {
      const double stops = d_that_stops_at(n, way.scaled(f)) * (1 + way_inset) * way.square();
      best.consider(f, largest(f) * way.square());
      best.consider(f, std::max(stops, best_delta(way, f, BestDelta::least)));
    };
    const double at_low = spare(ends.low);
    const double at_high = spare(ends.high);
    if (at_low >= 0) {
      consider(ends.low);
    } else if (at_high > 0) {
      consider(std::min(
          ends.high, (1 + way_inset) * falling_root([&](double f) { return -spare(f); }, ends.low,
                                                    ends.high, -at_low, -at_high)));
    }
  }
}

/// Where to begin. Not the middle: if only f binds, that is the answer of `robust`, and SLSQP
/// ends there in roundoff instead of convergence. A stop time that jumps where the number of
/// half-cycles does begins with the best of a grid.
DesignPoint start_of(const Way& way, Objective objective, const DesignRange& range) {
  const auto& [ends, inside] = range;
  BestPoint best(way, objective);
  if (objective != Objective::time || way.q == 0) {
    constexpr double start_fraction = 0.4;
    const double f = ends.low + start_fraction * (ends.high - ends.low);
    const double delta = best_delta(way, f, BestDelta::most_tolerant);
    if (objective == Objective::robust && admissible(way, f, delta)) {
      return {f, delta};
    }
    best.consider(f, delta);
    best.consider(inside.f, inside.delta);
    return best.place();
  }
  consider_stops(way, ends, best);
  constexpr int steps = 16;  // only for a start: the stops themselves were considered above
  const double least = bound_of(way, objective) + clearly_better;
  for (int i = 0; i <= steps && best.cost() > least; ++i) {
    const double f = ends.low + (ends.high - ends.low) * i / steps;
    const auto d = centre_range(way, f, way.limits.tolerance);
    for (const double part : {way_inset, 0.5, 1 - way_inset}) {
      if (d) {
        best.consider(f, (d->low + part * (d->high - d->low)) * way.square());
      }
    }
  }
  best.consider(inside.f, inside.delta);
  return best.place();
}

/// Some box of that tolerance fits.
bool has_box(Way way, double tolerance) {
  way.limits.tolerance = tolerance;
  return tolerance < 1 && any_point(way);
}

struct WayResult {
  DesignPoint point;
  double cost;
  double by_nlopt;  ///< the cost of its best point
  double along_f;
  NloptOutcome outcome;
};

std::optional<WayResult> search_way(const Way& way, const SearchOptions& options) {
  const auto range = design_range(way);
  if (!range) {
    return std::nullopt;
  }
  const Objective objective = options.objective;
  const NloptAlgorithm algorithm = find_algorithm(options.algorithm);
  const DesignPoint start = start_of(way, objective, *range);
  Tried tried{{}, HUGE_VAL, Eigen::Vector2d(way.scaled(start.f) / way.a_cap, 0.5)};
  const NloptProblem posed = way_posed(algorithm.constraints, way, objective, start, tried);
  SearchOptions budget = options;
  if (objective == Objective::time && way.q > 0 && algorithm.name.starts_with("LD_")) {
    // With gradients alone it may follow a jump of the time for thousands of steps.
    constexpr int enough = 25;
    budget.max_evaluations = std::min(enough, budget.max_evaluations);
  }
  NloptOutcome outcome = run(posed, algorithm.name, budget, [&] { return tried.best; });

  BestPoint by_nlopt(way, objective);
  const auto consider = [&](double x) {
    const double f = way.f_of(x * way.a_cap);
    // Not std::clamp: the ends of a region that is a point may cross by rounding.
    by_nlopt.consider(f > 0 ? std::max(range->f.low, std::min(f, range->f.high)) : f);
  };
  consider(outcome.x[0]);
  if (algorithm.constraints == ConstraintSupport::no) {
    consider(tried.best[0]);
  }
  // NLopt returns the best point that met all constraints to the last bit, which may be its start;
  // the last ones that it tried are those that it reached.
  constexpr std::size_t last = 3;
  for (const double x : std::span(tried.x).last(std::min(last, tried.x.size()))) {
    consider(x);
  }
  BestPoint best(way, objective);
  consider_along_f(way, objective, *range, best);
  best.consider(start.f, start.delta);
  best.consider(range->inside.f, range->inside.delta);
  const BestPoint& better = by_nlopt.cost() < best.cost() - clearly_better ? by_nlopt : best;
  return WayResult{better.point(), better.cost(), by_nlopt.cost(), best.cost(), std::move(outcome)};
}

}  // namespace

std::optional<SearchResult> search(const Problem& problem, const Limits& limits,
                                   const SearchOptions& options) {
  const double started = seconds_now();
  require_valid(problem, limits);
  require_valid(options);
  std::optional<WayResult> best;
  int evaluations = 0;
  double by_nlopt = HUGE_VAL;
  double along_f = HUGE_VAL;
  const bool robust = options.objective == Objective::robust;
  const auto visit = [&](const Way& way) {
    if (best && bound_of(way, options.objective) >= best->cost - clearly_better) {
      return way.q > 0;  // else nor is any later one better
    }
    if (best && robust && !has_box(way, clearly_better - best->cost)) {
      return true;
    }
    if (auto found = search_way(way, options)) {
      evaluations += found->outcome.evaluations;
      by_nlopt = std::min(by_nlopt, found->by_nlopt);
      along_f = std::min(along_f, found->along_f);
      if (!best || found->cost < best->cost - clearly_better) {
        best = std::move(found);
      }
    }
    return true;
  };
  if (robust && problem.residual) {
    // The most tolerant way is usually the last one, then the first: each saves the search of
    // others.
    std::vector<Way> ways;
    for_each_way(problem, limits, [&](const Way& way) {
      ways.push_back(way);
      return true;
    });
    std::stable_partition(ways.begin(), ways.end(), [](const Way& way) { return way.n == 0; });
    std::ranges::for_each(ways, visit);
  } else {
    for_each_way(problem, limits, visit);
  }
  if (!best) {
    return std::nullopt;
  }
  const auto value_of = [&](double cost) {
    return cost < HUGE_VAL ? std::optional(cost * objective_unit(options.objective, problem))
                           : std::nullopt;
  };
  return SearchResult{
      best->point,
      {std::string(find_algorithm(options.algorithm).name), best->outcome.status, evaluations,
       seconds_now() - started, value_of(by_nlopt), value_of(along_f)}};
}

}  // namespace stillpoint::design
