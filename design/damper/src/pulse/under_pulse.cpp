// SPDX-License-Identifier: MIT
#include "found.hpp"

#include "check/judge.hpp"
#include "check/runge_kutta.hpp"

#include <stillpoint/core/elementary.hpp>
#include <stillpoint/design/cross_check.hpp>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

namespace stillpoint::design {

namespace {

/// If both are below, the reduction is accurate to about 2 % in the peak.
constexpr double short_pulse = 0.2;
constexpr double small_friction = 0.2;

/// The rounding of a run in other units, over about ten pieces.
constexpr double map_tolerance = 1e-12;
constexpr double map_rounding = 16 * std::numeric_limits<double>::epsilon();
constexpr double kutta_tolerance = 1e-12;
constexpr double runge_kutta_tolerance = 1e-9;
/// The energy error that a thousand steps at that tolerance may add up to.
constexpr double runge_kutta_resolution = 1000 * kutta_tolerance;

std::vector<PulseWarning> warnings(const PulseCheck& check) {
  std::vector<PulseWarning> list;
  if (check.shortness > short_pulse) {
    list.push_back(PulseWarning::pulse_not_short);
  }
  if (check.friction_ratio > small_friction) {
    list.push_back(PulseWarning::friction_not_small);
  }
  return list;
}

/// The error of the motion that starts with the equivalent velocity.
void add_reduction(PulseCheck& check, const PulseProblem& problem, double f) {
  check.start = equivalent_start(problem.pulse, f);
  if (!check.start) {
    return;
  }
  const double p = problem.p;
  const double v0 = check.start->speed;
  const double radius = elementary::hypot(f, v0 * p);
  const double peak = v0 / (radius + f) * v0;
  check.peak_error = peak / check.response.peak_amplitude - 1;
  if (f <= v0 * p / std::sqrt(8.0)) {  // f3
    const double time =
        (elementary::atan2(v0 * p, f) + std::numbers::pi / 2 +
         elementary::atan2(f, std::sqrt(std::max(0.0, (radius - f) * (radius - 3 * f))))) /
        p;
    check.stop_time_error = (check.start->tau + time) / *check.response.stop_time - 1;
  }
}

/// How much larger than the motion the velocity is that a pulse gives and takes back: an error of
/// that velocity is this much larger beside what is left.
double taken_back(const PulseProblem& problem, const FirstReturn& expected) {
  const double given =
      (1 - expected.f) / std::max(angular_frequency(problem.pulse) / problem.p, 1.0);
  return given / expected.peak;
}

struct Tolerance {
  double end{};         ///< of what is compared
  double along{};       ///< of the velocity during the pulse
  double resolution{};  ///< a margin below it decides nothing
};

/// Completes a method. An error e of the arrival's energy moves the stop by sqrt(e) where the
/// arrival grazes, (31) of docs/theory.md; f barely below k amplifies errors by 1/(1 - f/k).
void compare(CheckMethod& method, const Tolerance& tolerance, const FirstReturn& expected,
             const PulseProblem& problem, double margin) {
  const double length = peak_load(problem.pulse) / problem.p / problem.p;
  const double peak = expected.peak * length;
  const double speed = expected.speed * length * problem.p;
  const double graze = std::max(expected.speed, std::sqrt(tolerance.end) * expected.f);
  method.tolerance = std::max(
      tolerance.end * std::max(1.0, expected.f / graze) / std::max(1 - expected.f, tolerance.end),
      tolerance.along * taken_back(problem, expected));
  const bool same_end = method.half_cycles == 1 && method.stop_position == 0;
  method.decided = same_end || margin > tolerance.resolution;
  conclude(method, same_end, std::abs(method.peak_amplitude / peak - 1),
           {std::abs(method.stop_time * problem.p / expected.time - 1),
            std::abs(method.arrival_speed - speed) / (problem.p * peak),
            std::abs(method.stop_position) / peak});
}

}  // namespace

Found finding_under_pulse(const PulseProblem& problem, const DesignPoint& point,
                          const FirstReturn& expected) {
  Found finding;
  finding.point = point;
  const auto& [f, delta, tolerance] = point;
  const Oscillator oscillator{problem.p, f, delta};
  PulseCheck check;
  check.pulse = problem.pulse;
  check.p = problem.p;
  check.shortness = problem.p / angular_frequency(problem.pulse);
  check.friction_ratio = f / peak_load(problem.pulse);

  const ForcedResponse& response = check.response;
  CheckMethod forced = measured([&] {
    check.response = forced_response(oscillator, {}, excitation(problem.pulse));
    return checked_figures(response);
  });
  forced.name = "forced_pulse";
  const double margin = response.decision_margin.value_or(0);
  compare(forced, {map_tolerance, map_rounding}, expected, problem, margin);
  // What was asked for, whatever the margin.
  forced.passed = forced.passed && response.stops_at_zero && response.half_cycles == 1.0 &&
                  response.peak_amplitude <= problem.beta;

  CheckMethod integrated = measured([&] {
    return integrate_under_pulse(oscillator, problem.pulse, response.peak_amplitude,
                                 kutta_tolerance);
  });
  integrated.name = "runge_kutta";
  compare(integrated, {runge_kutta_tolerance, kutta_tolerance, runge_kutta_resolution}, expected,
          problem, margin);

  add_reduction(check, problem, f);
  check.warnings = warnings(check);
  finding.response = response;
  finding.cross_check = {forced.passed && integrated.passed, {forced, integrated}};
  finding.pulse = std::move(check);
  return finding;
}

}  // namespace stillpoint::design
