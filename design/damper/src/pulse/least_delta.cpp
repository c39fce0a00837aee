// SPDX-License-Identifier: MIT
#include "pulse/worst_return.hpp"

#include <stillpoint/design/pulse.hpp>

#include <memory>

namespace stillpoint::design {

std::optional<double> least_delta(const PulseProblem& problem, double f) {
  return least_delta(problem)(f);
}

std::function<std::optional<double>(double)> least_delta(const PulseProblem& problem) {
  const auto worst = problem.has_ranges() ? std::make_shared<const WorstReturn>(problem) : nullptr;
  return [problem, worst](double f) -> std::optional<double> {
    const double k = peak_load(problem.pulse);
    const FirstReturn motion =
        worst ? worst->at(f / k) : first_return(problem.pulse, problem.p, f / k);
    return motion.returns
               ? std::optional(motion.need(problem.criterion) * (k / problem.p) * (k / problem.p))
               : std::nullopt;
  };
}

}  // namespace stillpoint::design
