// SPDX-License-Identifier: MIT
#include "settle.hpp"

#include "region_edges.hpp"

#include <boost/math/tools/toms748_solve.hpp>

#include <algorithm>
#include <cassert>
#include <cstdint>

namespace stillpoint::design {

DesignInterval design_interval(const Problem& problem, const Region& region) {
  // Far above rounding, so that no edge is a matter of the last digits, and far below what can be
  // built.
  constexpr double inset = 1e-9;
  assert(region.feasible);
  const double lower = *region.f_lower;
  const double upper = *region.f_upper;
  // f_max is not a graze: a design must keep away only from f3.
  const double high = std::min(upper, region.f3 * (1 - inset));
  // With f below 1e-9 V0 p the strip of Delta is narrower than a relative 4e-9; where f_max is even
  // less, the tolerance still needs some room below it.
  const double least = std::min(high / 2, inset * problem.v0 * problem.p);
  const double low = std::max(lower * (1 + inset), least);
  if (low <= high) {
    return {low, high};
  }
  return {lower, upper};
}

DesignPoint with_best_delta(const Problem& problem, const Limits& limits, double f) {
  const Edges edge = edges(problem, limits);
  const double f2 = edge.f2;
  const double cap = edge.delta_cap;
  const double box_of_f = std::clamp(std::min((f - f2) / f, (edge.f_cap - f) / f), 0.0, 1.0);
  const auto floor = [&](double tolerance) { return delta1(problem, f * (1 - tolerance)); };
  // (30): the middle of [floor, cap] has the tolerance (cap - floor)/(cap + floor), which falls as
  // the box of f grows.
  const auto surplus = [&](double tolerance) {
    const double low = floor(tolerance);
    return (cap - low) / (cap + low) - tolerance;
  };
  double box = box_of_f;
  const double at_box = surplus(box);
  const double at_zero = surplus(0);
  if (at_box < 0 && at_zero > 0) {
    std::uintmax_t most_evaluations = 100;
    box = boost::math::tools::toms748_solve(surplus, 0.0, box, at_zero, at_box,
                                            boost::math::tools::eps_tolerance<double>(),
                                            most_evaluations)
              .first;
  }
  const double low = floor(box);
  const double delta = low + (cap - low) / 2;
  return {f, delta, largest_tolerance(problem, limits, f, delta).value_or(0)};
}

}  // namespace stillpoint::design
