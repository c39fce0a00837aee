// SPDX-License-Identifier: MIT
#include <stillpoint/design/design.hpp>

#include "pulse/answer.hpp"
#include "search/objectives.hpp"

#include <cmath>
#include <optional>

namespace stillpoint::design {

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
  const auto in_units = [&](double value) {
    return std::isinf(value) ? std::nullopt
                             : std::optional(in_pulse_units(request.search.objective, value,
                                                            region.f_unit(), request.problem.p));
  };
  result.finding->pulse->searched = in_units(optimum->searched);
  result.finding->pulse->bracketed = in_units(optimum->bracketed);
  return result;
}

}  // namespace stillpoint::design
