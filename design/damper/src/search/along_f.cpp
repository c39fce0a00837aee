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

/// The least stop time with that f where rests off centre are allowed. From some Delta on the mass
/// stops an arrival earlier: both sides of each such jump are tried, and the ends.
double soonest_at(const Way& way, double f) {
  const double low = best_delta(way, f, BestDelta::least);
  const double high = best_delta(way, f, BestDelta::largest);
  double least = HUGE_VAL;
  const auto consider = [&](double delta) {
    if (low <= delta && delta <= high) {
      least = std::min(least, way_cost(way, Objective::time, {f, delta, 0}));
    }
  };
  consider(low);
  consider(high);
  for (int n = 1; n <= way.passages() && n < least; ++n) {
    const double jump = d_that_stops_at(n, way.scaled(f)) * way.square();
    consider(jump * (1 + way_inset));
    consider(jump * (1 - way_inset));
  }
  return least;
}

/// The same over all f. It jumps where such a Delta becomes small enough to be allowed, which it
/// does as f grows; between two jumps the minimum is sought.
double soonest(const Way& way, const Interval& f) {
  double least = HUGE_VAL;
  const auto between = [&](double low, double high) {
    const auto worth = [&](double at) { return -soonest_at(way, at); };
    const auto nowhere = [](double, double) { return false; };
    if (low <= high) {
      least = std::min({least, soonest_at(way, low), soonest_at(way, high),
                        -highest(worth, {low, high}, HUGE_VAL, nowhere).value});
    }
  };
  double end = f.high;
  for (int n = 1; n <= way.passages() && n < least; ++n) {
    const auto lacking = [&](double at) {
      return d_that_stops_at(n, way.scaled(at)) * way.square() -
             best_delta(way, at, BestDelta::largest);
    };
    const double at_low = lacking(f.low);
    const double at_end = lacking(end);
    if (at_low > 0 && at_end < 0) {
      const double jump = falling_root(lacking, f.low, end, at_low, at_end);
      between(jump * (1 + way_inset), end);
      end = jump * (1 - way_inset);
    } else if (at_low <= 0) {
      break;
    }
  }
  between(f.low, end);
  return least;
}

/// The time grows with f at the first arrival, and at later ones first falls and then grows; with
/// Delta it grows. The other objectives depend on f alone.
double least_cost(const Way& way, Objective objective, const Interval& f) {
  if (objective != Objective::time) {
    return objective_value(objective, way.scaled(falls_with_f(objective) ? f.high : f.low));
  }
  if (way.q > 0) {
    return soonest(way, f);
  }
  const auto worth = [&](double at) {
    return -way_cost(way, objective, {at, best_delta(way, at, BestDelta::least), 0});
  };
  return -highest(worth, f, HUGE_VAL, [](double, double) { return false; }).value;
}

}  // namespace

std::optional<double> optimum_along_f(const Problem& problem, const Limits& limits,
                                      Objective objective) {
  require_valid(problem, limits);
  double least = HUGE_VAL;
  if (objective == Objective::robust) {
    const double most = most_tolerant_of_all(problem, limits, limits.tolerance).tolerance;
    least = most > 0 ? -most : least;
  } else {
    for_each_way(problem, limits, [&](const Way& way) {
      if (const auto range = design_range(way)) {
        least = std::min(least, least_cost(way, objective, range->f));
      }
      return true;
    });
  }
  return least < HUGE_VAL ? std::optional(least * objective_unit(objective, problem))
                          : std::nullopt;
}

}  // namespace stillpoint::design
