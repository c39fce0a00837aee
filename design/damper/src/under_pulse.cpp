// SPDX-License-Identifier: MIT
#include "finding.hpp"

#include "judge.hpp"

#include <stillpoint/core/names.hpp>
#include <stillpoint/design/cross_check.hpp>

#include <algorithm>

namespace stillpoint::design {

namespace {

constexpr Names warning_names(
    std::to_array<Named<PulseWarning>>({{PulseWarning::pulse_not_short, "pulse_not_short"},
                                        {PulseWarning::friction_not_small, "friction_not_small"}}));

/// Where both are below, the reduction is good to about 2 % in the peak.
constexpr double short_pulse = 0.2;
constexpr double small_friction = 0.2;
/// For a pulse so short that only the rounding of the forced run remains.
constexpr double least_tolerance = 1e-9;

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

}  // namespace

std::string_view name(PulseWarning warning) noexcept {
  return warning_names.name(warning);
}

std::optional<PulseWarning> parse_pulse_warning(std::string_view name) noexcept {
  return warning_names.parse(name);
}

PulseCheck check_under_pulse(const PulseProblem& problem, Finding& finding) {
  const double f = finding.point.f;
  const double delta = finding.point.delta;
  PulseCheck result;
  result.shortness = problem.p / angular_frequency(problem.pulse);
  result.friction_ratio = f / peak_load(problem.pulse);
  result.start = equivalent_start(problem.pulse, f).value();

  CheckMethod method;
  method.wall_time_s = timed([&] {
    result.response = forced_response({problem.p, f, delta}, {}, excitation(problem.pulse));
  });
  const Response& forced = result.response;
  method.peak_amplitude = forced.peak_amplitude;
  method.peak_acceleration = forced.peak_acceleration;
  method.stop_time = *forced.stop_time - result.start.tau;
  method.arrival_speed = forced.arrival_speed.value_or(0);
  method.half_cycles = *forced.half_cycles;
  method.stop_position = *forced.stop_position;

  const Problem reduced = problem_at(problem, f);
  const Prediction prediction = predict(reduced, f);
  const double allowed = std::max(least_tolerance, result.shortness * result.shortness);
  // The pulse itself accelerates the mass more than the spring does later.
  const Quality quality{"forced_pulse", allowed, allowed, false};
  judge(method, quality, prediction, reduced, f, delta,
        finding.response.decision_margin.value_or(0));

  result.peak_error = prediction.peak_amplitude / forced.peak_amplitude - 1;
  if (method.half_cycles == prediction.half_cycles && forced.stops_at_zero) {
    result.stop_time_error = (result.start.tau + prediction.stop_time) / *forced.stop_time - 1;
  }
  result.warnings = warnings(result);
  // The search has already required that. Near f3 nothing else decides it.
  method.passed = method.passed && forced.stops_at_zero && forced.half_cycles == 1.0 &&
                  forced.peak_amplitude <= problem.beta;
  finding.cross_check.methods.push_back(method);
  finding.cross_check.passed = finding.cross_check.passed && method.passed;
  return result;
}

}  // namespace stillpoint::design
