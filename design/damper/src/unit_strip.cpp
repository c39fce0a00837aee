// SPDX-License-Identifier: MIT
#include "unit_strip.hpp"

#include <boost/math/tools/toms748_solve.hpp>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <numbers>

namespace stillpoint::design::unit {

namespace {

/// Where an increasing function is 0; the end that is nearest where it is not.
template <class Function>
double rising_root(const Function& function, double low, double high) {
  const double at_low = function(low);
  const double at_high = function(high);
  if (at_low >= 0 || at_high <= 0) {
    return at_low >= 0 ? low : high;
  }
  std::uintmax_t most_evaluations = 100;
  const auto bracket = boost::math::tools::toms748_solve(
      function, low, high, at_low, at_high, boost::math::tools::eps_tolerance<double>(),
      most_evaluations);
  return bracket.first;
}

/// The ratio d/a^2 at the high corner from which on the strip is wide enough for R, by (50).
std::optional<double> least_ratio(Criterion criterion, int n, double tolerance) {
  const double k = (1 - tolerance) / (1 + tolerance);
  const auto room = [&](double ratio) {
    return stop_edge(criterion, n, k, k * ratio).square - reach_edge(n, 1, ratio).square;
  };
  if (room(0) >= 0) {
    return 0;
  }
  constexpr double farther = 16;
  constexpr double farthest = 1e24;  // a = 1e-12, far below what a design takes
  double ratio = 1;
  while (room(ratio) <= 0) {
    ratio *= farther;
    if (ratio > farthest) {
      return std::nullopt;
    }
  }
  const double below = ratio == 1 ? 0 : ratio / farther;
  std::uintmax_t most_evaluations = 100;
  return boost::math::tools::toms748_solve(room, below, ratio, room(below), room(ratio),
                                           boost::math::tools::eps_tolerance<double>(),
                                           most_evaluations)
      .second;
}

}  // namespace

EdgeSpeed followed_back(const EdgeStart& start, int steps, double d) {
  const auto [radius, radius_by_a, phi, phi_by_a] = start;
  double r = radius;
  double by_a = radius_by_a;
  double by_d = 0;
  for (int i = 0; i < steps; ++i) {
    const double arrival = std::sqrt(r * r + 2 * d);
    const double kept = arrival > 0 ? r / arrival : 1;
    by_a = 2 * phi_by_a + kept * by_a;
    by_d = kept * by_d + (arrival > 0 ? 1 / arrival : 0);
    r = 2 * phi + arrival;
  }
  return {(r - phi) * (r + phi), 2 * (r * by_a - phi * phi_by_a), 2 * r * by_d};
}

EdgeSpeed reach_edge(int n, double a, double d) {
  return followed_back({3 * a, 3, a}, n - 1, d);
}

EdgeSpeed stop_edge(Criterion criterion, int n, double a, double d) {
  const double start = criterion == Criterion::published ? 0 : 1;
  return followed_back({start * a, start, a}, n, d);
}

double strip_tip(int n) {
  return 1 / (2 * std::sqrt(n * (n + 1.0)));
}

std::optional<Ends> high_corners(Criterion criterion, int n, double tolerance, double d_cap) {
  const auto ratio = least_ratio(criterion, n, tolerance);
  if (!ratio) {
    return std::nullopt;
  }
  const double high = *ratio == 0 ? strip_tip(n) : 1 / std::sqrt(reach_edge(n, 1, *ratio).square);
  if (*ratio * high * high > d_cap) {
    return std::nullopt;
  }
  const double k = (1 - tolerance) / (1 + tolerance);
  const double d = std::min(d_cap, 1.0);  // at d = 1 no strip is reached
  return Ends{
      rising_root([&](double a) { return stop_edge(criterion, n, k * a, k * d).square - 1; }, 0,
                  high),
      high};
}

std::optional<Ends> centre_range(Criterion criterion, int n, double tolerance, double d_cap,
                                 double a) {
  const double low_a = a * (1 - tolerance);
  const double high_a = a * (1 + tolerance);
  if (reach_edge(n, high_a, 0).square > 1) {
    return std::nullopt;
  }
  // n - 1 passages take 2 (n - 1) d at least, so much V0 has to bring; likewise n.
  const double reached =
      rising_root([&](double d) { return reach_edge(n, high_a, d).square - 1; }, 0, 0.5 / (n - 1));
  const double stopped = rising_root(
      [&](double d) { return stop_edge(criterion, n, low_a, d).square - 1; }, 0, 0.5 / n);
  const Ends ends{stopped / (1 - tolerance), std::min(reached, d_cap) / (1 + tolerance)};
  return ends.low <= ends.high ? std::optional(ends) : std::nullopt;
}

double strip_tolerance(Criterion criterion, int n, double a, double d) {
  const double reach = rising_root(
      [&](double r) { return reach_edge(n, a * (1 + r), d * (1 + r)).square - 1; }, 0, 1);
  const double stop = rising_root(
      [&](double r) { return 1 - stop_edge(criterion, n, a * (1 - r), d * (1 - r)).square; }, 0, 1);
  return std::min(reach, stop);
}

Course course(int n, double a, double d, double error) {
  constexpr double steepest = 1e8;  // as in stop_phase_slope
  Course now;
  double r = std::sqrt(1 + a * a);
  double r_by_a = a / r;
  double r_by_d = 0;
  for (int k = 1; k <= n; ++k) {
    const double t = r - 2 * a;
    const double v = std::sqrt((r - a) * (r + a));  // the departure
    const double w = std::sqrt(std::max(0.0, (t - a) * (t + a)));
    now.phase += std::numbers::pi - std::asin(a / r) + std::asin(std::min(1.0, a / t));
    // d asin(a/r) = (da - (a/r) dr)/v, d asin(a/t) = (da - (a/t) dt)/w.
    const double slope = 1 / std::max(w, 1 / steepest);
    now.by_a += -(1 - a / r * r_by_a) / v + (1 - a / t * (r_by_a - 2)) * slope;
    now.by_d += a / r * r_by_d / v - a / t * r_by_d * slope;
    now.grazing +=
        w * w > error ? a / (t * t) / w : 2 * std::min(1.0, std::sqrt(error) / a) / error;
    now.arrival_speed = w;
    if (k == n) {
      break;
    }
    const double next = t * t - 2 * d;
    if (next > 9 * a * a) {
      const double r_next = std::sqrt(next);
      r_by_a = t / r_next * (r_by_a - 2);
      r_by_d = (t * r_by_d - 1) / r_next;
      r = r_next;
    } else {
      r = 3 * a;
      r_by_a = 3;
      r_by_d = 0;
    }
  }
  return now;
}

}  // namespace stillpoint::design::unit
