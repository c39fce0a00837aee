// SPDX-License-Identifier: MIT
// The optimum without NLopt, along f alone: docs/theory.md sections 8 and 12.

#include "search/objectives.hpp"
#include "way/extent.hpp"
#include "way/highest.hpp"
#include "way/room.hpp"
#include "way/space.hpp"

#include <stillpoint/design/search.hpp>

#include <algorithm>
#include <cmath>

namespace stillpoint::design {

namespace {

/// The largest tolerance of a way is at least what was asked for and more than `found`, or 0.
double tolerance_above(const Way& way, double found) {
  Limits limits = way.limits;
  limits.tolerance = std::max(found, limits.tolerance);
  if (clearly_empty(Way(way.problem, limits, way.n))) {
    return 0;
  }
  limits.tolerance = 0;
  const double largest = most_tolerant(Way(way.problem, limits, way.n)).tolerance;
  return largest >= way.limits.tolerance ? largest : 0;
}

/// The peak falls with f and the acceleration grows. The time grows with f at the first arrival,
/// and at later ones first falls and then grows; with Delta it grows.
double least_cost(const Way& way, Objective objective, const unit::Ends& f) {
  if (objective != Objective::time) {
    return objective_value(objective,
                           way.scaled(objective == Objective::amplitude ? f.high : f.low));
  }
  const auto soonest = [&](double at) {
    return -way_cost(way, objective, {at, best_delta(way, at, BestDelta::least), 0});
  };
  return -highest(soonest, f, HUGE_VAL, [](double, double) { return false; }).value;
}

}  // namespace

std::optional<double> optimum_along_f(const Problem& problem, const Limits& limits,
                                      Objective objective) {
  require_valid(problem, limits);
  if (objective == Objective::time && problem.residual.value_or(0) > 0) {
    return std::nullopt;  // it jumps
  }
  const bool robust = objective == Objective::robust;
  double least = robust ? 0 : HUGE_VAL;
  if (robust && problem.residual.value_or(0) > 0) {  // mostly the best: it spares the others
    least = -tolerance_above(Way(problem, limits, 0), 0);
  }
  for_each_way(problem, limits, [&](const Way& way) {
    if (robust && way.plain && -least * (2 * way.n - 1) >= 1) {
      return false;  // no later strip has more, (51)
    }
    if (robust) {
      least = std::min(least, -tolerance_above(way, -least));
    } else if (const auto range = design_range(way)) {
      least = std::min(least, least_cost(way, objective, range->f));
    }
    return true;
  });
  return least == (robust ? 0 : HUGE_VAL)
             ? std::nullopt
             : std::optional(least * objective_unit(objective, problem));
}

}  // namespace stillpoint::design
