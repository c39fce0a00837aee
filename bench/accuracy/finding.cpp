// SPDX-License-Identifier: MIT
#include "finding.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>

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

/// By central differences in 50 digits, which leave some fifteen of them.
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
  constexpr int seed = 20261121;
  Dice dice(seed);
  for (int i = 0; i < hard_case.neighbours; ++i) {
    const Inputs<double> inputs = hard_case.neighbour(dice);
    const Exact expected = hard_case.exact(widened(inputs));
    const double error = ulps(hard_case.kernel(inputs), expected);
    const double condition =
        hard_case.alike ? finding.condition : condition_number(hard_case, inputs, expected);
    finding.worst = std::max(finding.worst, error);
    finding.worst_by_condition =
        std::max(finding.worst_by_condition, error / std::max(1.0, condition));
    if (finding.naive_worst) {
      finding.naive_worst =
          std::max(*finding.naive_worst, ulps(hard_case.by_naive(inputs), expected));
    }
  }
  return finding;
}

}  // namespace stillpoint::accuracy
