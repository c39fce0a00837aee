// SPDX-License-Identifier: MIT
#include <stillpoint/design/design.hpp>

#include "pulse/answer.hpp"

#include <cmath>
#include <optional>

namespace stillpoint::design {

namespace {

/// An objective's value in the units of the request.
std::optional<double> in_units(const PulseRegion& region, Objective objective, double p,
                               double value) {
  if (std::isinf(value)) {
    return std::nullopt;
  }
  switch (objective) {
    case Objective::robust:
      return -value;
    case Objective::amplitude:
      return value * region.length_unit();
    case Objective::time:
      return value / p;
    case Objective::acceleration:
      break;
  }
  return value * region.f_unit();
}

}  // namespace

DesignResult design(const PulseRequest& request) {
  const auto& [problem, limits, options] = request;
  require_valid(options);
  require_valid(problem, limits);
  const PulseRegion region(problem, limits);
  const auto optimum = search(region, options);
  DesignResult result = around(optimum, request, region);
  if (!optimum) {
    return result;
  }
  const auto& [f, delta, tolerance] = optimum->found.point;
  const DesignPoint point{f * region.f_unit(), delta * region.delta_unit(), tolerance};
  add_finding(result, request, region, point, f);
  result.finding->search = optimum->found.record;
  result.finding->pulse->searched =
      in_units(region, options.objective, problem.p, optimum->searched);
  result.finding->pulse->bracketed =
      in_units(region, options.objective, problem.p, optimum->bracketed);
  return result;
}

}  // namespace stillpoint::design
