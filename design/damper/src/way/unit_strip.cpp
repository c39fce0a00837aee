// SPDX-License-Identifier: MIT
#include "way/unit_strip.hpp"

#include <stillpoint/core/elementary.hpp>

#include <algorithm>
#include <cmath>
#include <numbers>

namespace stillpoint::design::unit {

EdgeSpeed followed_back(const EdgeStart& start, int steps, double d) {
  if (start.zeta > 0) {
    return damped_back(start, steps, d);
  }
  const auto [radius, radius_by_a, phi, phi_by_a, zeta] = start;
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
    now.phase +=
        std::numbers::pi - elementary::asin(a / r) + elementary::asin(std::min(1.0, a / t));
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

Rest rest(double a, double d, int most, double error) {
  Rest now;
  double r = std::sqrt(1 + a * a);
  double v = 1;
  double side = 1;
  for (now.half_cycles = 1;; ++now.half_cycles, side = -side) {
    const double t = r - 2 * a;
    if (t < a) {  // (5), (6)
      now.phase += elementary::atan2(v, a) + (t > 0 ? std::numbers::pi : 0);
      now.position = side * (t > 0 ? a - t : v * v / (r + a));  // r - a, whose digits cancel
      now.grazing += 1 / (2 * r) + a / (r * r) / (2 * std::max(v, std::sqrt(error)));
      return now;
    }
    const double w = std::sqrt((t - a) * (t + a));
    now.phase += elementary::atan2(v, a) + std::numbers::pi / 2 + elementary::atan2(a, w);
    now.grazing +=
        w * w > error ? a / (t * t) / w : 2 * std::min(1.0, std::sqrt(error) / a) / error;
    now.arrival_speed = w;
    const double left = w * w - 2 * d;
    if (left <= 0 || now.half_cycles == most) {
      return now;
    }
    v = std::sqrt(left);
    r = std::sqrt(t * t - 2 * d);
  }
}

}  // namespace stillpoint::design::unit
