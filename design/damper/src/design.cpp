// SPDX-License-Identifier: MIT
#include <stillpoint/design/design.hpp>

#include "found.hpp"

#include <stillpoint/core/oscillator.hpp>
#include <stillpoint/design/region.hpp>

#include <fmt/format.h>

namespace stillpoint::design {

Found finding_of(const Problem& problem, const Limits& limits, const DesignPoint& point) {
  Found finding;
  finding.point = point;
  finding.arrival = arrival_of(problem, point.f, point.delta);
  finding.constraints = constraints(problem, limits, point.f, point.delta);
  const Oscillator oscillator{problem.p, point.f, point.delta};
  finding.response = free_response(oscillator, {0, problem.v0});
  finding.energies = motion_energies(oscillator, {0, problem.v0}, NoExcitation());
  add_practice(finding, problem, limits, point, finding.response);
  add_delta1(finding, problem, point.f);
  finding.works_for = works_for(problem, limits, point.f, point.delta);
  finding.cross_check =
      cross_check(predict(problem, point.f, point.delta), problem, point.f, point.delta);
  return finding;
}

DesignResult design(const DesignRequest& request) {
  const auto& [problem, limits, options, pulse, ranges] = request;
  if (pulse) {
    return design(pulse_request(request));
  }
  require_valid(options);
  DesignResult result{{admissible_region(problem, limits)}, request};
  const std::optional<SearchResult> found = search(problem, limits, options);
  if (!found) {
    if (result.region.feasible) {
      result.region.feasible = false;
      result.region.conflict = Conflict::narrower_than_rounding;
      result.region.f_lower = result.region.f_upper = std::nullopt;
    }
    explain(result, problem, limits);
    return result;
  }
  result.finding = finding_of(problem, limits, found->point);
  result.finding->search = found->record;
  return result;
}

double even_tolerance(const Problem& problem, const Limits& limits, const DesignPoint& point) {
  if (limits.shape == BoxShape{}) {
    return point.tolerance;
  }
  Limits even = limits;
  even.shape = {};
  return largest_tolerance(problem, even, point.f, point.delta).value_or(0);
}

double even_tolerance(const DesignResult& result) {
  const Found& found = *result.finding;
  return found.pulse ? found.pulse->even_tolerance
                     : even_tolerance(result.request.problem, result.request.limits, found.point);
}

std::string summary(const DesignResult& result) {
  if (!result.finding) {
    return "no damper: " + result.reason.value();
  }
  const Found& found = *result.finding;
  return fmt::format("f = {:.6g}, delta = {:.6g} within {:.3g} %: {}{}", found.point.f,
                     found.point.delta, 100 * found.point.tolerance, summary(found.response),
                     found.cross_check.passed ? "" : "; the cross-check failed");
}

}  // namespace stillpoint::design
