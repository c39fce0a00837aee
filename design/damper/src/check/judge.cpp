// SPDX-License-Identifier: MIT
#include "check/judge.hpp"

#include "check/runge_kutta.hpp"
#include "way/unit_strip.hpp"

#include <stillpoint/core/free_motion.hpp>
#include <stillpoint/core/input_error.hpp>
#include <stillpoint/core/oscillator.hpp>
#include <stillpoint/design/cross_check.hpp>

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
    // From a peak just beyond the dead zone the mass slips with this amplitude: it turns back late
    // by an error over that.
    const double slip = prediction.peak_amplitude - f / problem.p / problem.p;
    return std::max(
        {1.0,
         unit::rest(f / problem.p / problem.v0, d, static_cast<int>(prediction.half_cycles),
                    tolerance)
             .grazing,
         prediction.half_cycles == 1 && slip > 0 ? prediction.peak_amplitude / slip : 1});
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

/// 2e-16 (2 + n) with n = 2 and some room.
constexpr Quality map_quality{"half_cycle_map", 1e-12, 1e-15};
/// Resolution: the energy error that a thousand steps at this tolerance may add up to.
constexpr double integrator_tolerance = 1e-12;
constexpr Quality runge_kutta_quality{"runge_kutta", 1e-9, 1000 * integrator_tolerance};
/// Where it disagrees, it integrates again: what is left is not its own error.
constexpr double closer_tolerance = 1e-14;

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
  conclude(
      method, same_end, error_of(method.peak_amplitude, prediction.peak_amplitude),
      {quality.acceleration ? error_of(method.peak_acceleration, prediction.peak_acceleration) : 0,
       error_of(method.stop_time, prediction.stop_time),
       std::abs(method.arrival_speed - prediction.arrival_speed) / problem.v0,
       std::abs(method.stop_position - prediction.stop_position) / prediction.peak_amplitude});
}

void conclude(CheckMethod& method, bool same_end, double error_of_peak,
              std::initializer_list<double> others) {
  method.relative_error = error_of_peak;
  for (const double error : others) {
    // Not std::max: that may ignore a NaN.
    if (method.decided && (std::isnan(error) || error > method.relative_error)) {
      method.relative_error = error;
    }
  }
  method.passed = method.relative_error <= method.tolerance && (same_end || !method.decided);
}

MotionFigures checked_figures(const Response& response) {
  return {.peak_amplitude = response.peak_amplitude,
          .peak_acceleration = response.peak_acceleration,
          .stop_time = response.stop_time.value_or(0),
          .arrival_speed = response.arrival_speed.value_or(0),
          .half_cycles = response.half_cycles.value_or(0),
          .stop_position = response.stop_position.value_or(0)};
}

CrossCheck cross_check(const Prediction& prediction, const Problem& problem, double f,
                       double delta) {
  require_within("delta", delta, 0, largest_square);
  const Oscillator oscillator{problem.p, f, delta};
  double margin = 0;

  CheckMethod map = measured([&] {
    const Response response = free_response(oscillator, {0, problem.v0});
    margin = response.decision_margin.value_or(0);
    return checked_figures(response);
  });
  judge(map, map_quality, prediction, problem, f, delta, margin);

  const auto by_runge_kutta = [&](double tolerance) {
    CheckMethod method =
        measured([&] { return integrate_free_motion(oscillator, problem.v0, tolerance); });
    judge(method, runge_kutta_quality, prediction, problem, f, delta, margin);
    return method;
  };
  CheckMethod integrated = by_runge_kutta(integrator_tolerance);
  if (!integrated.passed) {
    integrated = by_runge_kutta(closer_tolerance);
  }

  return {map.passed && integrated.passed, {map, integrated}};
}

}  // namespace stillpoint::design
