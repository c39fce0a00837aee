// SPDX-License-Identifier: MIT
#include "way/extent.hpp"

#include "falling_root.hpp"
#include "region/edges.hpp"
#include "way/highest.hpp"
#include "way/room.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>

namespace stillpoint::design {

namespace {

/// The f of the centres whose box is within the edges of f alone.
std::optional<Interval> within_f(const Way& way, double tolerance) {
  if (!(way.f_top > 0)) {
    return std::nullopt;
  }
  const Interval all{lowest_centre(way.f2, tolerance * way.limits.shape.f_low),
                     highest_centre(way.f_top, tolerance * way.limits.shape.f_high)};
  return all.low <= all.high ? std::optional(all) : std::nullopt;
}

/// The least f that a design takes.
double least_f(const Way& way, double high) {
  return std::min(high / 2, way_inset * way.problem.v0 * way.problem.p);
}

/// The largest f of boxes whose high side is not on the tip, where the weakest hit only grazes x =
/// 0. That of the paper's task is known to the last bit, so that the centre alone stays off it.
double off_the_tip(const Way& way, double high) {
  return way.is_papers_task()  ? std::min(high, way.tip * (1 - way_inset))
         : way.tip < way.f_cap ? high * (1 - way_inset)
                               : high;
}

/// The part that is searched: not the open end at 0, and not the tip.
Interval scanned_f(const Way& way, const Interval& all) {
  const double low = std::max(all.low, least_f(way, all.high));
  const double high = off_the_tip(way, all.high);
  return low <= high ? Interval{low, high} : all;
}

/// Nothing but the stop depends on f, and friction helps it.
bool friction_makes_room(const Way& way) {
  return way.n == 0 || (way.n == 1 && way.v_low > 0);
}

/// The f with the most room for Delta, or with enough.
double roomiest_f(const Way& way, const Interval& f) {
  const double t = way.limits.tolerance;
  if (friction_makes_room(way)) {
    return f.high;
  }
  constexpr double enough = 1e-6;  // more than rounding, if there is more
  const auto no_room = [&](double from, double to) {
    return no_room_between(way, way.scaled(from), way.scaled(to), t);
  };
  return highest([&](double at) { return room(way, way.scaled(at), t); }, f, enough, no_room).at;
}

}  // namespace

std::optional<WayPoint> any_point(const Way& way) {
  const double t = way.limits.tolerance;
  const auto all = within_f(way, t);
  if (!all) {
    return std::nullopt;
  }
  const auto fits = [&](double f, double delta) {
    return admissible(way, f, delta) ? std::optional(WayPoint{f, delta}) : std::nullopt;
  };
  const auto at = [&](double f) { return fits(f, best_delta(way, f, BestDelta::middle)); };
  if (const auto roomiest = at(roomiest_f(way, scanned_f(way, *all)))) {
    return roomiest;
  }
  // If the tolerance is only just allowed, only the corner of the caps is left, or, where the tip
  // is a root, what is off its last digits.
  constexpr double few_ulps = 4e-15;
  const double delta = highest_centre(way.delta_cap, t * way.limits.shape.delta_high);
  if (const auto corner = fits(all->high, delta)) {
    return corner;
  }
  return at(std::max(std::midpoint(all->low, all->high), all->high * (1 - few_ulps)));
}

namespace {

Interval feasible_around(const Way& way, const WayPoint& inside) {
  const double t = way.limits.tolerance;
  const Interval all = within_f(way, t).value();
  const Interval scanned = scanned_f(way, all);
  const auto left = [&](double f) { return room(way, way.scaled(f), t); };
  const double at_inside = left(inside.f);
  const auto end = [&](double from, double open) {
    const double at_from = left(from);
    if (at_from >= 0 || at_inside <= 0) {
      return at_from >= 0 ? open : inside.f;
    }
    const double at = from < inside.f ? falling_root([&](double f) { return -left(f); }, from,
                                                     inside.f, -at_from, -at_inside)
                                      : falling_root(left, inside.f, from, at_inside, at_from);
    return std::clamp(at, all.low, all.high);
  };
  return {end(scanned.low, all.low), end(scanned.high, all.high)};
}

}  // namespace

std::optional<Interval> feasible_f(const Way& way) {
  const auto inside = any_point(way);
  return inside ? std::optional(feasible_around(way, *inside)) : std::nullopt;
}

std::optional<DesignRange> design_range(const Way& way) {
  const auto inside = any_point(way);
  if (!inside) {
    return std::nullopt;
  }
  const Interval all = feasible_around(way, *inside);
  const bool closes = all.high < within_f(way, way.limits.tolerance)->high;
  const double high = closes ? all.high * (1 - way_inset) : off_the_tip(way, all.high);
  const Interval off_edges{std::max(all.low * (1 + way_inset), least_f(way, high)), high};
  return DesignRange{off_edges.low <= off_edges.high ? off_edges : all, *inside};
}

DesignPoint most_tolerant(const Way& way) {
  const auto all = within_f(way, 0);
  if (!all) {
    return {};
  }
  const Interval f = scanned_f(way, *all);
  // It is often largest where a box as wide as Delta allows, or f itself, just fits below the cap
  // of f or above its floor. These are known to the last digits.
  const BoxShape& shape = way.limits.shape;
  const auto below_cap = [&](double t) { return way.f_top / (1 + t * shape.f_high); };
  const auto above_floor = [&](double t) { return way.f2 / (1 - t * shape.f_low); };
  const auto as_delta_allows = [&](const auto& f_of_box) -> std::optional<double> {
    const auto spare = [&](double t) { return room(way, way.scaled(f_of_box(t)), t); };
    const double most = 1 - way_inset;
    const double at_most = spare(most);
    const double at_zero = at_most >= 0 ? at_most : spare(0);
    return at_most >= 0  ? std::optional(most)
           : at_zero > 0 ? std::optional(falling_root(spare, 0, most, at_zero, at_most))
                         : std::nullopt;
  };
  const auto as_delta_allows_below = as_delta_allows(below_cap);
  const double as_f_allows =
      way.f2 > 0 ? (way.f_top - way.f2) / (way.f_top * shape.f_low + way.f2 * shape.f_high)
                 : HUGE_VAL;
  if (friction_makes_room(way)) {
    return as_delta_allows_below
               ? with_best_delta(
                     way, std::clamp(below_cap(std::min(*as_delta_allows_below, as_f_allows)),
                                     f.low, f.high))
               : DesignPoint();
  }
  const Highest best = highest([&](double at) { return tolerance_at(way, way.scaled(at)); }, f);
  if (!(best.value > 0)) {
    return {};
  }
  DesignPoint largest = with_best_delta(way, best.at);
  const auto consider = [&](double at) {
    if (at >= f.low && at <= f.high) {
      const DesignPoint now = with_best_delta(way, at);
      largest = now.tolerance > largest.tolerance ? now : largest;
    }
  };
  if (as_delta_allows_below) {
    consider(below_cap(*as_delta_allows_below));
  }
  if (way.f2 > 0) {
    if (const auto as_delta_allows_above = as_delta_allows(above_floor)) {
      consider(above_floor(*as_delta_allows_above));
    }
    consider(below_cap(as_f_allows));
  }
  return largest;
}

DesignPoint most_tolerant_of_all(const Problem& problem, Limits limits, double least) {
  limits.tolerance = least;
  DesignPoint best;
  const auto visit = [&](Way way) {
    if (way.plain && best.tolerance * (2 * way.n - 1) >= 1) {
      return false;  // no later strip has more, (51)
    }
    way.limits.tolerance = 0;
    const DesignPoint its = most_tolerant(way);
    best = its.tolerance > best.tolerance ? its : best;
    return true;
  };
  if (problem.residual.value_or(0) > 0) {  // usually the best: it saves the others
    visit(Way(problem, limits, 0));
  }
  for_each_way(problem, limits, visit);
  return best.tolerance >= least ? best : DesignPoint();
}

}  // namespace stillpoint::design
