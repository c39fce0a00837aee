// SPDX-License-Identifier: MIT
#pragma once

// The truth about a pulse: its own motions over f, each over a notch that it cannot pass.

#include <stillpoint/core/forced_motion.hpp>
#include <stillpoint/design/design.hpp>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <optional>
#include <vector>

namespace stillpoint::design_test {

struct Scanned {
  double f{0};
  bool holds{false};  ///< every requirement that is not one of Delta
  double need{0};     ///< the least Delta that stops it
  double peak_amplitude{0};
  std::optional<double> stop_time{};
  double peak_absolute_acceleration{0};
};

/// One pulse with one spring; the rest is that of the request.
inline Scanned scanned(const design::PulseRequest& request, const design::Pulse& pulse, double p,
                       double f) {
  const auto& [problem, limits, search] = request;
  constexpr double unpassable = 1e200;
  const ForcedResponse motion = forced_response({p, f, unpassable}, {}, design::excitation(pulse));
  const double w = motion.arrival_speed.value_or(0);
  const double phi = problem.criterion == design::Criterion::published ? f / p : 0;
  return {f,
          motion.stops_at_zero && motion.half_cycles == 1.0 &&
              motion.peak_amplitude <= problem.beta && f <= limits.f_max.value_or(HUGE_VAL) &&
              motion.peak_absolute_acceleration <= limits.acceleration_max.value_or(HUGE_VAL),
          (w * w + phi * phi) / 2,
          motion.peak_amplitude,
          motion.stop_time,
          motion.peak_absolute_acceleration};
}

/// The largest tolerance of a box whose ends in f are points of the scan; negative without any.
inline double best_tolerance(const std::vector<Scanned>& points, const design::Limits& limits) {
  double best = -1;
  for (std::size_t i = 0; i < points.size(); ++i) {
    double need = 0;
    for (std::size_t j = i; j < points.size() && points[j].holds; ++j) {
      need = std::max(need, points[j].need);
      const double tolerance = (points[j].f - points[i].f) / (points[j].f + points[i].f);
      if (need * (1 + tolerance) <= limits.delta_max.value_or(HUGE_VAL) * (1 - tolerance)) {
        best = std::max(best, tolerance);
      }
    }
  }
  return best;
}

}  // namespace stillpoint::design_test
