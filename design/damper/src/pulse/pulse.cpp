// SPDX-License-Identifier: MIT
#include <stillpoint/core/input_error.hpp>
#include <stillpoint/core/names.hpp>
#include <stillpoint/core/oscillator.hpp>
#include <stillpoint/design/pulse.hpp>

#include <fmt/format.h>

#include <array>

namespace stillpoint::design {

namespace {

void require_followed(double lambda, double p) {
  if (!(lambda <= fastest_pulse * p && p <= slowest_pulse * lambda)) {
    throw InputError(
        "lambda", lambda,
        fmt::format("must be from {:g} p to {:g} p (p = {}): a {} pulse cannot be "
                    "computed",
                    1 / slowest_pulse, fastest_pulse, p, lambda < p ? "longer" : "shorter"));
  }
}

}  // namespace

void require_valid(const PulseProblem& problem, const Limits& limits) {
  const double k = peak_load(problem.pulse);
  const double lambda = angular_frequency(problem.pulse);
  const double k_low = problem.ranges.k_low.value_or(k);
  const double lambda_high = problem.ranges.lambda_high.value_or(lambda);
  const double p_high = problem.p_high.value_or(problem.p);
  require_within("k", k, smallest_speed, largest_speed);
  if (k_low == 0) {
    throw InputError(
        "k", 0,
        "a range must begin above 0: a pulse hardly stronger than f leaves the mass off centre");
  }
  require_within("k", k_low, smallest_speed, k);
  require_within("p", problem.p, smallest_speed, largest_speed);
  require_within("p", p_high, problem.p, largest_speed);
  require_valid(excitation(problem.pulse));
  require_within("lambda", lambda_high, lambda, largest_speed);
  require_followed(lambda, problem.p);
  require_followed(lambda, p_high);
  require_followed(lambda_high, problem.p);
  require_valid(Problem{k / lambda, problem.p, problem.beta, problem.criterion}, limits);
  require_valid(Problem{k_low / lambda_high, p_high, problem.beta, problem.criterion}, limits);
}

PulseProblem pulse_problem(const Problem& problem, const Pulse& pulse, const PulseRanges& ranges) {
  return {pulse, problem.p, problem.beta, problem.criterion, ranges, problem.p_high};
}

double peak_load(const Pulse& pulse) {
  return std::visit([](const auto& kind) { return kind.k; }, pulse);
}

double angular_frequency(const Pulse& pulse) {
  return std::visit([](const auto& kind) { return kind.lambda; }, pulse);
}

Pulse with(const Pulse& pulse, double k, double lambda) {
  return std::visit([&]<class Kind>(const Kind&) { return Pulse(Kind{k, lambda}); }, pulse);
}

std::string_view name(const Pulse& pulse) {
  return stillpoint::name(excitation(pulse));
}

Excitation excitation(const Pulse& pulse) {
  return std::visit([](const auto& kind) { return Excitation(kind); }, pulse);
}

std::optional<EquivalentStart> equivalent_start(const Pulse& pulse, double f) {
  return stillpoint::equivalent_start(excitation(pulse), f);
}

}  // namespace stillpoint::design
