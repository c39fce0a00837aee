// SPDX-License-Identifier: MIT
#include <stillpoint/core/free_motion.hpp>
#include <stillpoint/design/cross_check.hpp>
#include <stillpoint/design/runge_kutta.hpp>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <limits>

namespace stillpoint::design {

namespace {

constexpr double map_tolerance = 1e-12;
constexpr double runge_kutta_tolerance = 1e-9;
constexpr double integrator_tolerance = 1e-12;

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

void judge(CheckMethod& method, const Prediction& prediction) {
  method.relative_error = std::max(
      {relative(method.peak_amplitude, prediction.peak_amplitude),
       relative(method.stop_time, prediction.stop_time),
       std::abs(method.stop_position - prediction.stop_position) / prediction.peak_amplitude});
  method.passed =
      method.relative_error <= method.tolerance && method.half_cycles == prediction.half_cycles;
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
  const Oscillator<double> oscillator{problem.p, f, delta};
  const auto tolerance = [&](double base) {
    return base * grazing_factor(prediction, problem, f, base);
  };

  CheckMethod map;
  map.name = "half_cycle_map";
  map.tolerance = tolerance(map_tolerance);
  map.wall_time_s = timed([&] {
    const Response response = free_response(oscillator, {0, problem.v0});
    map.peak_amplitude = response.peak_amplitude;
    map.stop_time = *response.stop_time;
    map.half_cycles = *response.half_cycles;
    map.stop_position = *response.stop_position;
  });
  judge(map, prediction);

  CheckMethod integrated;
  integrated.name = "runge_kutta";
  integrated.tolerance = tolerance(runge_kutta_tolerance);
  integrated.wall_time_s = timed([&] {
    const IntegratedMotion motion =
        integrate_free_motion(oscillator, problem.v0, integrator_tolerance);
    integrated.peak_amplitude = motion.peak_amplitude;
    integrated.stop_time = motion.stop_time;
    integrated.half_cycles = static_cast<double>(motion.half_cycles);
    integrated.stop_position = motion.stop_position;
  });
  judge(integrated, prediction);

  return {map.passed && integrated.passed, {map, integrated}};
}

}  // namespace stillpoint::design
