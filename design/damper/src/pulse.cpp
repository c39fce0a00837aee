// SPDX-License-Identifier: MIT
#include <stillpoint/core/input_error.hpp>
#include <stillpoint/core/oscillator.hpp>
#include <stillpoint/design/pulse.hpp>

#include <fmt/format.h>

namespace stillpoint::design {

namespace {

/// As far as a forced run reaches, forced_motion.hpp.
constexpr double shortest_pulse = 1e12;

}  // namespace

void require_valid(const PulseProblem& problem, const Limits& limits) {
  require_within("k", peak_load(problem.pulse), smallest_speed, largest_speed);
  require_within("p", problem.p, smallest_speed, largest_speed);
  require_valid(excitation(problem.pulse));
  const double lambda = angular_frequency(problem.pulse);
  if (!(lambda >= problem.p && lambda <= shortest_pulse * problem.p)) {
    throw InputError("lambda", lambda,
                     fmt::format("must be from p to {:g} p (p = {}): {}", shortest_pulse, problem.p,
                                 lambda < problem.p ? "a longer pulse is no impulse"
                                                    : "a shorter pulse cannot be followed"));
  }
  if (limits.acceleration_max) {
    // S falls and then grows with f, since V(f) falls: no bound of f alone keeps it.
    throw InputError("acceleration_max", *limits.acceleration_max,
                     "cannot be combined with a pulse; give an initial velocity");
  }
  require_valid(problem_at(problem, 0), limits);
}

double peak_load(const Pulse& pulse) {
  return std::visit([](const auto& kind) { return kind.k; }, pulse);
}

double angular_frequency(const Pulse& pulse) {
  return std::visit([](const auto& kind) { return kind.lambda; }, pulse);
}

std::string_view name(const Pulse& pulse) {
  return std::holds_alternative<HalfSine>(pulse) ? "half-sine" : "rectangle";
}

Excitation excitation(const Pulse& pulse) {
  return std::visit([](const auto& kind) { return Excitation(kind); }, pulse);
}

std::optional<EquivalentStart> equivalent_start(const Pulse& pulse, double f) {
  return std::visit([f](const auto& kind) { return stillpoint::equivalent_start(kind, f); }, pulse);
}

Problem problem_at(const PulseProblem& problem, double f) {
  const auto start = equivalent_start(problem.pulse, f);
  return {start ? start->speed : 0, problem.p, problem.beta, problem.criterion};
}

}  // namespace stillpoint::design
