// SPDX-License-Identifier: MIT
#include "region/edges.hpp"

#include "falling_root.hpp"
#include "region/limit_table.hpp"
#include "unit_problem.hpp"
#include "way/unit_strip.hpp"
#include "wide.hpp"

#include <stillpoint/core/oscillator.hpp>

#include <algorithm>
#include <cmath>

namespace stillpoint::design {

namespace {

double largest_returning_f(double v0, double p) {
  const Wide f = Wide(v0) * p / root_of_eight();
  const auto nearest = static_cast<double>(f);
  constexpr double roundings = 0x1p-100;  // more than f is off
  if (std::abs(f.rest()) > roundings * nearest) {
    return rounded_down(f);
  }
  return spare_of_return(v0, p, nearest) < 0 ? std::nextafter(nearest, 0.0) : nearest;
}

/// With the least damping, where the undamped f2 is above 0.
double damped_f2(const Problem& problem, double undamped) {
  const double unit = problem.p * problem.v0;
  const double b = problem.beta * problem.p / problem.v0;
  const auto lacking = [&](double a) {
    return 1 - unit::followed_back({b + a, 1, a, 1, problem.zeta.low}, 0, 0).square;
  };
  const double at_0 = lacking(0);
  const double at_most = lacking(undamped / unit);
  return at_0 <= 0     ? 0
         : at_most < 0 ? falling_root(lacking, 0, undamped / unit, at_0, at_most) * unit
                       : undamped;
}

/// With the most damping.
double damped_f3(const Problem& problem) {
  const double zeta = problem.zeta.high;
  const double turn = 2 + unit::shrinks_by(zeta);
  return problem.starting_v0() * problem.p /
         std::sqrt(unit::followed_back({turn, 0, 1, 0, zeta}, 0, 0).square);
}

}  // namespace

double largest_delta_of_start(double v0) {
  const double rounded = v0 * v0 / 2;
  return holds_at_start(rounded, v0) ? std::nextafter(rounded, 0.0) : rounded;
}

Edges edges(const Problem& problem, const Limits& limits) {
  const double v0 = problem.v0;
  const double p = problem.p;
  const double beta = problem.beta;
  const Wide speed = Wide(beta) * p;
  const double unit = speed > 1 ? 0x1p-64 : 0x1p64;  // the product is beyond a double without it
  Edges result{};
  result.f1 = problem.beta * problem.p * problem.p / problem.breakaway;
  result.f2 =
      is_same(v0, speed)
          ? 0
          : rounded_up(less_product(v0, beta, p).times(unit) * (v0 + speed) / (2 * beta * unit));
  result.f3 = largest_returning_f(problem.starting_v0(), p);
  if (problem.zeta.high > 0) {
    result.f3 = damped_f3(problem);
    result.f2 = result.f2 > 0 ? damped_f2(problem, result.f2) : result.f2;
  }
  result.f_max = least_limit(Bounded::f, limits);
  result.f4 = figures_edge(problem, limits);
  result.f_cap = std::min({result.f3, result.f_max, result.f4});
  result.delta2 = largest_delta_of_start(problem.starting_v0());
  result.delta_cap = std::min(result.delta2, least_limit(Bounded::delta, limits));
  return result;
}

bool needs_a_notch(const Problem& problem, const Limits& limits) {
  return least_limit(Bounded::delta, limits) == 0 && problem.residual.value_or(0) == 0;
}

bool box_fits(double floor, double cap, double tolerance) {
  return lowest_centre(floor, tolerance) <= highest_centre(cap, tolerance);
}

double unchecked_delta1(const Problem& problem, double f) {
  const int unit = std::ilogb(problem.v0);  // so that no square loses digits
  const double v0 = std::ldexp(problem.v0, -unit);
  f = std::ldexp(f, -unit);
  const double p = problem.stiffest_p();
  if (f / p == 0) {  // Delta2 itself
    return largest_delta_of_start(problem.v0);
  }
  const bool published = problem.criterion == Criterion::published;
  constexpr double far_beyond = 1e30;  // there V0 is lost in phi
  if (!(f / p < far_beyond)) {
    return published ? std::ldexp(f / p, unit) * std::ldexp(f / p, unit - 1) : 0;
  }
  const Wide phi = Wide(f) / p;
  const Wide radius = root(square(Wide(v0)) + square(phi));
  Wide twice_delta = square(radius - twice(phi));
  if (!published) {
    const Wide spare = spare_of_return(v0, p, f) / p;
    twice_delta = (radius - phi) * std::max(Wide(0), spare) * (v0 + root_of_eight() * phi) /
                  (radius + 3 * phi);
  }
  return std::ldexp(static_cast<double>(twice_delta), 2 * unit - 1);
}

bool stop_fits(const Problem& problem, const Edges& edges, const Limits& limits) {
  const double f = highest_centre(edges.f_cap, limits.tolerance);
  const double delta = highest_centre(edges.delta_cap, limits.tolerance);
  return unchecked_delta1(problem, f * (1 - limits.tolerance)) < delta * (1 - limits.tolerance);
}

double highest_centre(double cap, double tolerance) {
  double f = cap / (1 + tolerance);
  while (f * (1 + tolerance) > cap) {
    f = std::nextafter(f, -HUGE_VAL);  // the cap f4 may be negative
  }
  return f;
}

double lowest_centre(double floor, double tolerance) {
  if (floor <= 0) {
    return 0;
  }
  double f = floor / (1 - tolerance);
  while (f * (1 - tolerance) < floor) {
    f = std::nextafter(f, HUGE_VAL);
  }
  return f;
}

}  // namespace stillpoint::design
