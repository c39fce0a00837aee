// SPDX-License-Identifier: MIT
#include <stillpoint/design/design.hpp>

#include "pulse/answer.hpp"
#include "search/objectives.hpp"

#include <cmath>
#include <optional>

namespace stillpoint::design {

std::optional<PulseDamper> damper(const PulseRequest& request) {
  const PulseRegion region = region_for(request);
  const auto optimum = search(region, request.search);
  if (!optimum) {
    return std::nullopt;
  }
  const double unit_f = optimum->found.point.f;
  DesignPoint point = region.in_units(optimum->found.point);
  point.tolerance = even_tolerance(request, region, point, unit_f);
  const PulseProblem shown = region.profile()->largest_peak(request.problem, unit_f);
  return PulseDamper{point,
                     forced_response({shown.p, point.f, point.delta}, {}, excitation(shown.pulse))};
}

DesignResult design(const PulseRequest& request) {
  const PulseRegion region = region_for(request);
  const auto optimum = search(region, request.search);
  DesignResult result = around(optimum, request, region);
  if (!optimum) {
    return result;
  }
  add_finding(result, request, region, region.in_units(optimum->found.point),
              optimum->found.point.f);
  result.finding->search = optimum->found.record;
  const auto value_of = [&](double value) {
    return std::isinf(value) ? std::nullopt
                             : std::optional(in_pulse_units(request.search.objective, value,
                                                            region.f_unit(), request.problem.p));
  };
  result.finding->search->by_nlopt = value_of(optimum->searched);
  result.finding->search->along_f = value_of(optimum->bracketed);
  return result;
}

}  // namespace stillpoint::design
