// SPDX-License-Identifier: MIT
#include "check/judge.hpp"
#include "check/rest.hpp"
#include "check/runge_kutta.hpp"
#include "region/edges.hpp"
#include "unit_problem.hpp"
#include "way/unit_strip.hpp"

#include <stillpoint/core/free_motion.hpp>
#include <stillpoint/core/input_error.hpp>
#include <stillpoint/core/oscillator.hpp>
#include <stillpoint/design/cross_check.hpp>
#include <stillpoint/design/region.hpp>

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace stillpoint::design {

namespace {

/// (31): an error e of the arrival energy moves the stop phase by about e phi / w for phi >> w, and
/// by sqrt(e) where w vanishes. Of a later arrival (53).
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

/// 2e-16 (2 + n) with n = 2 and some room.
constexpr Quality map_quality{"half_cycle_map", 1e-12, 1e-15};
/// Resolution: the energy error that a thousand steps at this tolerance may add up to.
constexpr double integrator_tolerance = 1e-12;
constexpr Quality runge_kutta_quality{"runge_kutta", 1e-9, 1000 * integrator_tolerance};

}  // namespace

Prediction predict(const Problem& problem, double f) {
  require_valid(problem);
  require_within("f", f, 0, edges(problem, {}).f3);
  const double a = std::min(f / problem.p / problem.v0, unit::a3);
  Prediction prediction;
  prediction.peak_amplitude = unit::peak(a) * problem.v0 / problem.p;
  prediction.peak_acceleration = unit::radius(a) * problem.v0 * problem.p;
  prediction.stop_time = unit::stop_phase(a) / problem.p;
  prediction.arrival_speed = unit::arrival_speed(a) * problem.v0;
  return prediction;
}

namespace {

/// Wherever the strongest hit comes to rest.
Prediction predict_rest(const Problem& problem, double f, double delta) {
  const double a = f / problem.p / problem.v0;
  const auto rest =
      unit::rest(a, delta / problem.v0 / problem.v0, static_cast<int>(problem.arrivals));
  Prediction prediction;
  prediction.peak_amplitude = unit::peak(a) * problem.v0 / problem.p;
  prediction.peak_acceleration = unit::radius(a) * problem.v0 * problem.p;
  prediction.stop_time = rest.phase / problem.p;
  prediction.arrival_speed = rest.arrival_speed * problem.v0;
  prediction.half_cycles = rest.half_cycles;
  prediction.stop_position = rest.position * problem.v0 / problem.p;
  return prediction;
}

}  // namespace

Prediction predict(const Problem& problem, double f, double delta) {
  if (!is_plain(problem, {})) {
    return predict_rest(problem, f, delta);
  }
  const auto arrival = arrival_of(problem, f, delta);
  if (!arrival) {
    throw InputError("f, delta", fmt::format("{}, {}", f, delta),
                     fmt::format("must stop at one of the first {} arrivals", problem.arrivals));
  }
  if (*arrival == 1) {
    return predict(problem, f);
  }
  const double a = f / problem.p / problem.v0;
  const auto course = unit::course(static_cast<int>(*arrival), a, delta / problem.v0 / problem.v0);
  Prediction prediction;
  prediction.peak_amplitude = unit::peak(a) * problem.v0 / problem.p;
  prediction.peak_acceleration = unit::radius(a) * problem.v0 * problem.p;
  prediction.stop_time = course.phase / problem.p;
  prediction.arrival_speed = course.arrival_speed * problem.v0;
  prediction.half_cycles = static_cast<double>(*arrival);
  return prediction;
}

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
      // Not std::max: that may pass over a NaN.
      if (std::isnan(error) || error > method.relative_error) {
        method.relative_error = error;
      }
    }
  }
  method.passed = method.relative_error <= method.tolerance && (same_end || !method.decided);
}

void take(CheckMethod& method, const IntegratedMotion& motion) {
  method.peak_amplitude = motion.peak_amplitude;
  method.peak_acceleration = motion.peak_acceleration;
  method.stop_time = motion.stop_time;
  method.arrival_speed = motion.arrival_speed;
  method.half_cycles = static_cast<double>(motion.half_cycles);
  method.stop_position = motion.stop_position;
}

CrossCheck cross_check(const Prediction& prediction, const Problem& problem, double f,
                       double delta) {
  require_within("delta", delta, std::numeric_limits<double>::min(), largest_square);
  const Oscillator oscillator{problem.p, f, delta};
  double margin = 0;

  CheckMethod map;
  map.wall_time_s = timed([&] {
    const Response response = free_response(oscillator, {0, problem.v0});
    map.peak_amplitude = response.peak_amplitude;
    map.peak_acceleration = response.peak_acceleration;
    map.stop_time = *response.stop_time;
    map.arrival_speed = response.arrival_speed.value_or(0);
    map.half_cycles = *response.half_cycles;
    map.stop_position = *response.stop_position;
    margin = response.decision_margin.value_or(0);
  });
  judge(map, map_quality, prediction, problem, f, delta, margin);

  CheckMethod integrated;
  integrated.wall_time_s = timed([&] {
    take(integrated, integrate_free_motion(oscillator, problem.v0, integrator_tolerance));
  });
  judge(integrated, runge_kutta_quality, prediction, problem, f, delta, margin);

  return {map.passed && integrated.passed, {map, integrated}};
}

}  // namespace stillpoint::design
