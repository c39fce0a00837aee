// SPDX-License-Identifier: MIT
#include "pulse/profile.hpp"

#include <stillpoint/core/input_error.hpp>
#include <stillpoint/core/names.hpp>
#include <stillpoint/core/oscillator.hpp>
#include <stillpoint/design/pulse.hpp>

#include <fmt/format.h>

namespace stillpoint::design {

namespace {

constexpr Names warning_names(
    std::to_array<Named<PulseWarning>>({{PulseWarning::pulse_not_short, "pulse_not_short"},
                                        {PulseWarning::friction_not_small, "friction_not_small"}}));

}  // namespace

void require_valid(const PulseProblem& problem, const Limits& limits) {
  require_within("k", peak_load(problem.pulse), smallest_speed, largest_speed);
  require_within("p", problem.p, smallest_speed, largest_speed);
  require_valid(excitation(problem.pulse));
  const double lambda = angular_frequency(problem.pulse);
  if (!(lambda <= fastest_pulse * problem.p && problem.p <= slowest_pulse * lambda)) {
    throw InputError("lambda", lambda,
                     fmt::format("must be from {:g} p to {:g} p (p = {}): a {} pulse cannot be "
                                 "followed",
                                 1 / slowest_pulse, fastest_pulse, problem.p,
                                 lambda < problem.p ? "longer" : "shorter"));
  }
  const double speed = peak_load(problem.pulse) / lambda;
  require_valid(Problem{speed, problem.p, problem.beta, problem.criterion}, limits);
}

double peak_load(const Pulse& pulse) {
  return std::visit([](const auto& kind) { return kind.k; }, pulse);
}

double angular_frequency(const Pulse& pulse) {
  return std::visit([](const auto& kind) { return kind.lambda; }, pulse);
}

std::string_view name(const Pulse& pulse) {
  return stillpoint::name(excitation(pulse));
}

Excitation excitation(const Pulse& pulse) {
  return std::visit([](const auto& kind) { return Excitation(kind); }, pulse);
}

std::optional<EquivalentStart> equivalent_start(const Pulse& pulse, double f) {
  return std::visit(
      [f](const auto& kind) -> std::optional<EquivalentStart> {
        if constexpr (requires { stillpoint::equivalent_start(kind, f); }) {
          return stillpoint::equivalent_start(kind, f);
        } else {
          return std::nullopt;
        }
      },
      pulse);
}

std::optional<double> least_delta(const PulseProblem& problem, double f) {
  const double k = peak_load(problem.pulse);
  const FirstReturn motion = first_return(problem.pulse, problem.p, f / k);
  return motion.returns
             ? std::optional(motion.need(problem.criterion) * (k / problem.p) * (k / problem.p))
             : std::nullopt;
}

std::string_view name(PulseWarning warning) noexcept {
  return warning_names.name(warning);
}

std::optional<PulseWarning> parse_pulse_warning(std::string_view name) noexcept {
  return warning_names.parse(name);
}

}  // namespace stillpoint::design
