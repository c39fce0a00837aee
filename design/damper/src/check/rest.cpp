// SPDX-License-Identifier: MIT
#include "check/rest.hpp"

#include <stillpoint/core/elementary.hpp>

#include <algorithm>
#include <cmath>
#include <numbers>

namespace stillpoint::design::unit {

Rest rest(double a, double d, int most, double error) {
  Rest now;
  double r = std::sqrt(1 + a * a);
  double v = 1;
  double side = 1;
  for (now.half_cycles = 1;; ++now.half_cycles, side = -side) {
    const double t = r - 2 * a;
    if (t < a) {  // (5), (6)
      now.phase += elementary::atan2(v, a) + (t > 0 ? std::numbers::pi : 0);
      now.position = side * (t > 0 ? a - t : r - a);
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
