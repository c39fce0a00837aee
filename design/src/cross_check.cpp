// SPDX-License-Identifier: MIT
#include <stillpoint/core/free_motion.hpp>
#include <stillpoint/core/input_error.hpp>
#include <stillpoint/core/oscillator.hpp>
#include <stillpoint/design/cross_check.hpp>
#include <stillpoint/design/runge_kutta.hpp>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <limits>

namespace stillpoint::design {

namespace {

/// How exact a method is. `resolution` is the decision margin below which its own errors may tip a
/// decision: for the map 2e-16 (2 + n) with n = 2 and some room, for the integrator the energy
/// error that a thousand steps at its tolerance may add up to.
struct Quality {
  std::string_view name;
  double tolerance;
  double resolution;
};

constexpr Quality map_quality{"half_cycle_map", 1e-12, 1e-15};
constexpr double integrator_tolerance = 1e-12;
constexpr Quality runge_kutta_quality{"runge_kutta", 1e-9, 1000 * integrator_tolerance};

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

/// The rest of a method, whose figures are there already.
void judge(CheckMethod& method, const Quality& quality, const Prediction& prediction,
           const Problem& problem, double f, double margin) {
  const bool same_end = method.half_cycles == prediction.half_cycles &&
                        method.stop_position == prediction.stop_position;
  method.name = quality.name;
  method.tolerance = quality.tolerance * grazing_factor(prediction, problem, f, quality.tolerance);
  method.decided = same_end || margin > quality.resolution;
  method.relative_error = relative(method.peak_amplitude, prediction.peak_amplitude);
  if (method.decided) {
    for (const double error :
         {relative(method.peak_acceleration, prediction.peak_acceleration),
          relative(method.stop_time, prediction.stop_time),
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

template <class Run>
double timed(const Run& run) {
  const auto started = std::chrono::steady_clock::now();
  run();
  return std::chrono::duration<double>(std::chrono::steady_clock::now() - started).count();
}

}  // namespace

CrossCheck cross_check(const Prediction& prediction, const Problem& problem, double f,
                       double delta) {
  require_within("delta", delta, std::numeric_limits<double>::min(), largest_square);
  const Oscillator<double> oscillator{problem.p, f, delta};
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
  judge(map, map_quality, prediction, problem, f, margin);

  CheckMethod integrated;
  integrated.wall_time_s = timed([&] {
    const IntegratedMotion motion =
        integrate_free_motion(oscillator, problem.v0, integrator_tolerance);
    integrated.peak_amplitude = motion.peak_amplitude;
    integrated.peak_acceleration = motion.peak_acceleration;
    integrated.stop_time = motion.stop_time;
    integrated.arrival_speed = motion.arrival_speed;
    integrated.half_cycles = static_cast<double>(motion.half_cycles);
    integrated.stop_position = motion.stop_position;
  });
  judge(integrated, runge_kutta_quality, prediction, problem, f, margin);

  return {map.passed && integrated.passed, {map, integrated}};
}

}  // namespace stillpoint::design
