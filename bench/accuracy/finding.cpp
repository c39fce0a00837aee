// SPDX-License-Identifier: MIT
#include "hard_case.hpp"

#include <stillpoint/core/for_each_entry.hpp>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <vector>

namespace stillpoint::accuracy {

namespace {

Inputs<Exact> widened(const Inputs<double>& inputs) {
  return {inputs.begin(), inputs.end()};
}

double ulps(double value, const Exact& expected) {
  const auto nearest = static_cast<double>(expected);
  const double ulp = std::nextafter(std::abs(nearest), HUGE_VAL) - std::abs(nearest);
  return std::abs(static_cast<double>((Exact(value) - expected) / ulp));
}

/// By central differences in 50 digits, of which about fifteen remain.
double condition_number(const HardCase& hard_case, const Inputs<double>& inputs,
                        const Exact& value) {
  const Exact step("1e-20");
  Exact sum = 0;
  for (std::size_t i = 0; i < inputs.size(); ++i) {
    Inputs<Exact> changed = widened(inputs);
    changed[i] *= 1 + step;
    const Exact above = hard_case.exact(changed);
    changed[i] = Exact(inputs[i]) * (1 - step);
    sum += abs(Exact((above - hard_case.exact(changed)) / (2 * step)));
  }
  return static_cast<double>(sum / abs(value));
}

/// The errors of one neighbour.
struct Errors {
  double kernel;
  double by_condition;
  double naive;
};

Errors errors_at(const HardCase& hard_case, const Inputs<double>& inputs, double condition_alike) {
  const Exact expected = hard_case.exact(widened(inputs));
  const double error = ulps(hard_case.kernel(inputs), expected);
  // A neighbour that is more than a few ulps off may be harder than the rest: use its own number.
  constexpr double few_ulps = 4;
  const bool alike = hard_case.alike && error <= few_ulps * std::max(1.0, condition_alike);
  const double condition = alike ? condition_alike : condition_number(hard_case, inputs, expected);
  const double naive = hard_case.by_naive ? ulps(hard_case.by_naive(inputs), expected) : 0;
  return {error, error / std::max(1.0, condition), naive};
}

/// Every neighbour, on all cores: the reference in 50 digits takes minutes.
std::vector<Errors> errors_of_neighbours(const HardCase& hard_case, double condition_alike) {
  constexpr int seed = 20261121;
  Dice dice(seed);
  std::vector<Inputs<double>> neighbours;
  neighbours.reserve(static_cast<std::size_t>(hard_case.neighbours));
  for (int i = 0; i < hard_case.neighbours; ++i) {
    neighbours.push_back(hard_case.neighbour(dice));
  }
  std::vector<Errors> errors(neighbours.size());
  for_each_entry(std::ssize(neighbours), {}, {}, [&](std::ptrdiff_t entry) {
    const auto i = static_cast<std::size_t>(entry);
    errors[i] = errors_at(hard_case, neighbours[i], condition_alike);
  });
  return errors;
}

}  // namespace

Finding examine(const HardCase& hard_case) {
  Finding finding;
  const Exact value = hard_case.exact(widened(hard_case.inputs));
  finding.expected = static_cast<double>(value);
  finding.error = ulps(hard_case.kernel(hard_case.inputs), value);
  finding.condition = condition_number(hard_case, hard_case.inputs, value);
  if (hard_case.by_naive) {
    finding.naive_error = ulps(hard_case.by_naive(hard_case.inputs), value);
    finding.naive_worst = finding.naive_error;
  }
  finding.worst = finding.error;
  finding.worst_by_condition = finding.error / std::max(1.0, finding.condition);
  for (const Errors& errors : errors_of_neighbours(hard_case, finding.condition)) {
    finding.worst = std::max(finding.worst, errors.kernel);
    finding.worst_by_condition = std::max(finding.worst_by_condition, errors.by_condition);
    if (finding.naive_worst) {
      finding.naive_worst = std::max(*finding.naive_worst, errors.naive);
    }
  }
  return finding;
}

}  // namespace stillpoint::accuracy
