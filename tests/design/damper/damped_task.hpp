// SPDX-License-Identifier: MIT
#pragma once

#include "suites_of_records.hpp"

namespace stillpoint::design_test {

/// The closed forms and their limits as a load case with damping.
inline RecordDesignRequest as_case(const DesignRequest& exact, const Interval& zeta) {
  const auto& [problem, limits, options, pulse, ranges] = exact;
  RecordDesignRequest request = under_hit(zeta, problem.beta);
  LoadCase& only = request.cases.front();
  only.v0 = pulse ? std::nullopt : std::optional(problem.v0);
  only.pulse = pulse;
  only.weakest = problem.v0_low.value_or(problem.v0) / problem.v0;
  only.limits.residual = problem.residual.value_or(0);
  only.limits.passages = static_cast<double>(problem.arrivals - 1);
  only.limits.acceleration = limits.acceleration_max;
  request.p = {problem.p, problem.p};
  request.breakaway = problem.breakaway;
  request.f_max = limits.f_max;
  request.delta_max = limits.delta_max;
  if (problem.p_high) {
    request.spring = {1 - problem.p / *problem.p_high, 0};
  }
  if (limits.tolerance > 0) {
    const Spread both{limits.tolerance, limits.tolerance};
    request.tolerance = {both, both, {}, {}};
    request.requires_tolerance = true;
  }
  return request;
}

}  // namespace stillpoint::design_test
