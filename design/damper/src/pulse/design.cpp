// SPDX-License-Identifier: MIT
#include "finding.hpp"
#include "pulse/pulse_run.hpp"
#include "pulse/region.hpp"
#include "pulse/search.hpp"
#include "pulse/verdict.hpp"

#include <stillpoint/design/design.hpp>

#include <cmath>

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

void add_finding(DesignResult& result, const PulseRequest& request, const PulseRegion& region,
                 const SearchResult& found, double unit_f) {
  const auto& [problem, limits, options] = request;
  const FirstReturn worst = region.at(unit_f);
  const PulseProblem shown = region.profile()->largest_peak(problem, unit_f);
  const FirstReturn motion = first_return(shown.pulse, shown.p, unit_f);
  result.reduced_v0 = reduced_v0(shown.pulse, found.point.f);
  result.finding = finding_under_pulse(shown, limits, found, motion);
  result.finding->constraints = constraints_of(request, found.point, worst, region);
  result.finding->pulse->even_tolerance = even_tolerance(request, region, found.point, unit_f);
  if (problem.has_ranges()) {
    result.finding->pulse->worst =
        PulseWorst{worst.peak * region.length_unit(), worst.acceleration * region.f_unit(),
                   worst.time / problem.p};
  }
}

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
  add_finding(result, request, region, {point, optimum->found.record}, f);
  result.finding->pulse->searched =
      in_units(region, options.objective, problem.p, optimum->searched);
  result.finding->pulse->bracketed =
      in_units(region, options.objective, problem.p, optimum->bracketed);
  return result;
}

}  // namespace stillpoint::design
