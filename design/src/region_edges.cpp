// SPDX-License-Identifier: MIT
#include "region_edges.hpp"

#include <stillpoint/design/region.hpp>

#include <algorithm>
#include <cmath>
#include <numbers>

namespace stillpoint::design {

Edges edges(const Problem& problem, const Limits& limits) {
  const long double v0 = problem.v0;
  const long double p = problem.p;
  const long double beta = problem.beta;
  const long double speed = beta * p;
  Edges result{};
  result.f2 = (v0 - speed) * (v0 + speed) / (2 * beta);
  result.f3 = v0 * p / (2 * std::numbers::sqrt2_v<long double>);
  result.f_cap = static_cast<double>(result.f3);
  if (limits.f_max) {
    result.f_cap = std::min(result.f_cap, *limits.f_max);
  }
  result.delta_cap = problem.v0 * problem.v0 / 2;
  if (limits.delta_max) {
    result.delta_cap = std::min(result.delta_cap, *limits.delta_max);
  }
  return result;
}

bool amplitude_fits_return(const Edges& edges, const Limits& limits) {
  const long double tolerance = limits.tolerance;
  return edges.f2 * (1 + tolerance) <= edges.f3 * (1 - tolerance);
}

bool amplitude_fits_f_max(const Edges& edges, const Limits& limits) {
  const long double tolerance = limits.tolerance;
  return !limits.f_max || edges.f2 * (1 + tolerance) <= *limits.f_max * (1 - tolerance);
}

bool stop_fits(const Problem& problem, const Edges& edges, const Limits& limits) {
  const double f = highest_centre(edges.f_cap, limits.tolerance);
  const double delta = highest_centre(edges.delta_cap, limits.tolerance);
  return delta1(problem, f * (1 - limits.tolerance)) < delta * (1 - limits.tolerance);
}

double highest_centre(double cap, double tolerance) {
  double f = cap / (1 + tolerance);
  while (f * (1 + tolerance) > cap) {
    f = std::nextafter(f, 0.0);
  }
  return f;
}

double lowest_centre(double floor, double tolerance) {
  double f = floor / (1 - tolerance);
  while (f * (1 - tolerance) < floor) {
    f = std::nextafter(f, HUGE_VAL);
  }
  return f;
}

}  // namespace stillpoint::design
