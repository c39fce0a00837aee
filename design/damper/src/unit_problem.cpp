// SPDX-License-Identifier: MIT
#include "unit_problem.hpp"

#include <stillpoint/core/elementary.hpp>

#include <algorithm>
#include <cassert>
#include <cmath>

namespace stillpoint::design::unit {

namespace {

/// s - 3a = (1 - 8a^2)/(s + 3a), which keeps its digits towards a3 where s and 3a meet.
double return_factor(double a) {
  const double root8_a = a / a3;
  return (1 - root8_a) * (1 + root8_a) / (radius(a) + 3 * a);
}

}  // namespace

double radius(double a) {
  return std::sqrt(1 + a * a);
}

double delta1(Criterion criterion, double a) {
  const double s = radius(a);
  if (criterion == Criterion::published) {
    const double speed = s - 2 * a;
    return speed * speed / 2;
  }
  return (s - a) * return_factor(a) / 2;
}

double delta1_slope(Criterion criterion, double a) {
  const double s = radius(a);
  if (criterion == Criterion::published) {
    return (s - 2 * a) * (a / s - 2);
  }
  return 4 * a - 2 * s - 2 * a * a / s;
}

double peak(double a) {
  return 1 / (radius(a) + a);
}

double peak_slope(double a) {
  return -peak(a) / radius(a);
}

double stop_phase(double a) {
  assert(a >= 0 && a <= a3);
  const double s = radius(a);
  return std::numbers::pi - elementary::asin(a / s) +
         elementary::asin(std::min(1.0, a / (s - 2 * a)));
}

double stop_phase_slope(double a) {
  assert(a >= 0 && a <= a3);
  constexpr double steepest = 1e8;  // of a square root 1e-16 before its end, where doubles stop
  const double s = radius(a);
  const double arc = s - 2 * a;
  // d/da asin(a / arc) with arc' = a/s - 2, and sqrt(arc^2 - a^2) = sqrt((s - a)(s - 3a)) = v_-.
  const double rise = (arc - a * (a / s - 2)) / arc;
  const double speed = arrival_speed(a);
  return -1 / (s * s) + (rise < steepest * speed ? rise / speed : steepest);
}

double arrival_speed(double a) {
  return std::sqrt(std::max(0.0, (radius(a) - a) * return_factor(a)));
}

}  // namespace stillpoint::design::unit
