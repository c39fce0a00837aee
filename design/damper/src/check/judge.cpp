// SPDX-License-Identifier: MIT
#include "check/judge.hpp"

#include "check/rest.hpp"
#include "way/unit_strip.hpp"

#include <algorithm>
#include <cmath>

namespace stillpoint::design {

namespace {

/// (31): an error e of the arrival energy moves the stop phase by about e phi / w for phi >> w, and
/// by sqrt(e) where w vanishes. For a later arrival, (53).
double grazing_factor(const Prediction& prediction, const Problem& problem, double f, double delta,
                      double tolerance) {
  const double d = delta / problem.v0 / problem.v0;
  if (prediction.stop_position != 0) {
    return std::max(1.0, unit::rest(f / problem.p / problem.v0, d,
                                    static_cast<int>(prediction.half_cycles), tolerance)
                             .grazing);
  }
  if (prediction.half_cycles > 1) {
    return std::max(1.0, unit::course(static_cast<int>(prediction.half_cycles),
                                      f / problem.p / problem.v0, d, tolerance)
                             .grazing);
  }
  const double phi = f / problem.p;
  const double w = std::max(prediction.arrival_speed, std::sqrt(tolerance) * phi);
  return phi > w ? phi / w : 1;
}

double error_of(double value, double expected) {
  return std::abs(value - expected) / expected;
}

}  // namespace

void judge(CheckMethod& method, const Quality& quality, const Prediction& prediction,
           const Problem& problem, double f, double delta, double margin) {
  const bool same_end = method.half_cycles == prediction.half_cycles &&
                        (method.stop_position == 0) == (prediction.stop_position == 0);
  method.name = quality.name;
  method.tolerance =
      quality.tolerance * grazing_factor(prediction, problem, f, delta, quality.tolerance);
  method.decided = same_end || margin > quality.resolution * prediction.half_cycles;
  method.relative_error = error_of(method.peak_amplitude, prediction.peak_amplitude);
  if (method.decided) {
    const double acceleration =
        quality.acceleration ? error_of(method.peak_acceleration, prediction.peak_acceleration) : 0;
    for (const double error :
         {acceleration, error_of(method.stop_time, prediction.stop_time),
          std::abs(method.arrival_speed - prediction.arrival_speed) / problem.v0,
          std::abs(method.stop_position - prediction.stop_position) / prediction.peak_amplitude}) {
      // Not std::max: that may ignore a NaN.
      if (std::isnan(error) || error > method.relative_error) {
        method.relative_error = error;
      }
    }
  }
  method.passed = method.relative_error <= method.tolerance && (same_end || !method.decided);
}

void take(CheckMethod& method, const IntegratedMotion& motion) {
  static_cast<MotionFigures&>(method) = motion;
}

}  // namespace stillpoint::design
