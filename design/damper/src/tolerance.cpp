// SPDX-License-Identifier: MIT
#include "region_edges.hpp"
#include "strip.hpp"
#include "unit_problem.hpp"
#include "way.hpp"

#include <stillpoint/core/input_error.hpp>
#include <stillpoint/core/oscillator.hpp>
#include <stillpoint/design/region.hpp>

#include <boost/math/tools/toms748_solve.hpp>

#include <algorithm>
#include <cassert>
#include <cstdint>
#include <limits>

namespace stillpoint::design {

namespace {

/// The R at which the box's low corner (a, d)(1 - R) meets Delta1: with c = 1 - R the root of
/// c d - Delta1(c a), which rises from -1/2 at c = 0 and is positive at c = 1.
double tolerance_of_stop(Criterion criterion, double a, double d) {
  const auto room = [&](double c) { return c * d - unit::delta1(criterion, c * a); };
  const double at_one = room(1);
  if (!(at_one > 0)) {
    return 0;
  }
  std::uintmax_t most_evaluations = 100;
  const auto bracket = boost::math::tools::toms748_solve(
      room, 0.0, 1.0, room(0), at_one, boost::math::tools::eps_tolerance<double>(),
      most_evaluations);
  return 1 - bracket.second;
}

}  // namespace

bool admissible(const Problem& problem, const Limits& limits, double f, double delta) {
  require_valid(problem, limits);
  if (!is_plain(problem, limits)) {
    require_within("f", f, 0, largest_square);
    require_within("delta", delta, 0, largest_square);
    return way_of(problem, limits, f, delta).has_value();
  }
  if (problem.arrivals > 1) {
    const auto arrival = arrival_of(problem, f, delta);
    if (arrival != 1) {
      return arrival &&
             admissible(StripTask(problem, limits, static_cast<int>(*arrival)), f, delta);
    }
    return admissible(with_one_arrival(problem), limits, f, delta);
  }
  return box_admissible(problem, problem, limits, f, delta);
}

std::optional<double> largest_tolerance(const Problem& problem, const Limits& limits, double f,
                                        double delta) {
  if (!is_plain(problem, limits)) {
    require_valid(problem, limits);
    std::optional<double> largest;
    const auto visit = [&](const Way& way) {
      const auto its = largest_tolerance(way, f, delta);
      largest = std::max(largest, its);  // empty is the least
      return true;
    };
    for_each_way(problem, limits, visit);
    if (f == 0) {
      visit(Way(problem, limits, 0));
    }
    return largest;
  }
  if (problem.arrivals > 1) {
    require_valid(problem, limits);
    const auto arrival = arrival_of(problem, f, delta);
    return !arrival        ? std::nullopt
           : *arrival == 1 ? largest_tolerance(with_one_arrival(problem), limits, f, delta)
                           : largest_tolerance(
                                 StripTask(problem, limits, static_cast<int>(*arrival)), f, delta);
  }
  const auto fits = [&](double tolerance) {
    Limits box = limits;
    box.tolerance = tolerance;
    return admissible(problem, box, f, delta);
  };
  if (!fits(0)) {
    return std::nullopt;
  }
  const Edges edge = edges(problem, limits);
  const double f2 = edge.f2;
  const double a = f / problem.p / problem.v0;
  const double d = delta / problem.v0 / problem.v0;
  double tolerance =
      std::min({f2 > 0 ? (f - f2) / f : 1, (edge.f_cap - f) / f, (edge.delta_cap - delta) / delta,
                tolerance_of_stop(problem.criterion, std::min(a, unit::a3), d)});
  // Rounding may leave the box a few ulps of 1 outside; as many steps bring it in.
  constexpr int most_steps = 64;
  tolerance = std::max(tolerance, 0.0);
  for (int i = 0; i < most_steps && tolerance > 0 && !fits(tolerance); ++i) {
    tolerance = std::max(0.0, tolerance - std::numeric_limits<double>::epsilon());
  }
  assert(fits(tolerance));
  // The root above is accurate only to a few ulps, so the requested value itself is tried.
  if (tolerance < limits.tolerance && fits(limits.tolerance)) {
    return limits.tolerance;
  }
  return tolerance;
}

}  // namespace stillpoint::design
