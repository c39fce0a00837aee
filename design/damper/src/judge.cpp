// SPDX-License-Identifier: MIT
#include "judge.hpp"

#include <algorithm>
#include <cmath>

namespace stillpoint::design {

namespace {

/// (31): an error e of the arrival energy moves the stop phase by about e phi / w for phi >> w, and
/// by sqrt(e) where w vanishes.
double grazing_factor(const Prediction& prediction, const Problem& problem, double f,
                      double tolerance) {
  const double phi = f / problem.p;
  const double w = std::max(prediction.arrival_speed, std::sqrt(tolerance) * phi);
  return phi > w ? phi / w : 1;
}

double relative(double value, double expected) {
  return std::abs(value - expected) / expected;
}

}  // namespace

void judge(CheckMethod& method, const Quality& quality, const Prediction& prediction,
           const Problem& problem, double f, double margin) {
  const bool same_end = method.half_cycles == prediction.half_cycles &&
                        method.stop_position == prediction.stop_position;
  method.name = quality.name;
  method.tolerance = quality.tolerance * grazing_factor(prediction, problem, f, quality.tolerance);
  method.decided = same_end || margin > quality.resolution;
  method.relative_error = relative(method.peak_amplitude, prediction.peak_amplitude);
  if (method.decided) {
    const double acceleration =
        quality.acceleration ? relative(method.peak_acceleration, prediction.peak_acceleration) : 0;
    for (const double error :
         {acceleration, relative(method.stop_time, prediction.stop_time),
          std::abs(method.arrival_speed - prediction.arrival_speed) / problem.v0,
          std::abs(method.stop_position - prediction.stop_position) / prediction.peak_amplitude}) {
      // Not std::max: that may pass over a NaN.
      if (std::isnan(error) || error > method.relative_error) {
        method.relative_error = error;
      }
    }
  }
  method.passed = method.relative_error <= method.tolerance && (same_end || !method.decided);
}

}  // namespace stillpoint::design
