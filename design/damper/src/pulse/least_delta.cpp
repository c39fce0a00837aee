// SPDX-License-Identifier: MIT
#include "pulse/region.hpp"

#include <stillpoint/design/pulse.hpp>

#include <algorithm>
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

std::function<std::optional<Interval>(double)> feasible_delta(const PulseProblem& problem,
                                                              const Limits& limits) {
  require_valid(problem, limits);
  const auto region = std::make_shared<const PulseRegion>(problem, limits);
  return [region](double f) -> std::optional<Interval> {
    const double tolerance = region->asked();
    const double low = region->low_of(f / region->f_unit(), tolerance);
    const double high = region->high_of(f / region->f_unit(), tolerance);
    KnownMotions known(*region->profile());
    const bool inside = std::ranges::any_of(region->islands(), [&](const Island& island) {
      return (island.low <= low || region->reaches_down_to_0(island)) && high <= island.high;
    });
    if (!inside || !known.at(low).returns) {
      return std::nullopt;
    }
    const Interval delta{known.need_between(low, high, region->criterion()) /
                             (1 - region->shape().delta_low * tolerance),
                         region->delta_max() / (1 + region->shape().delta_high * tolerance)};
    const double unit = region->delta_unit();
    return delta.low <= delta.high ? std::optional(Interval{delta.low * unit, delta.high * unit})
                                   : std::nullopt;
  };
}

}  // namespace stillpoint::design
