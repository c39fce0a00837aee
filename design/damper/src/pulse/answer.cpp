// SPDX-License-Identifier: MIT
// The region of a pulse, what would help where it is empty, and how a damper stands in it.

#include "pulse/answer.hpp"

#include "found.hpp"

#include <stillpoint/core/forced_motion.hpp>
#include <stillpoint/core/oscillator.hpp>
#include <stillpoint/design/works_for.hpp>

#include <algorithm>
#include <cmath>
#include <utility>

namespace stillpoint::design {

namespace {

/// As in tolerance.hpp. The largest tolerance searched does not exclude a larger one.
std::optional<DesignPoint> most_tolerant(const PulseRegion& region, const PulseProblem& problem,
                                         Limits limits) {
  const double asked = std::min(limits.tolerance, widest_tolerance);
  limits.tolerance = 0;
  const auto best = search(PulseRegion(region.profile(), problem, limits), {});
  if (!best || !(best->found.point.tolerance > 0 && best->found.point.tolerance < asked)) {
    return std::nullopt;
  }
  return region.in_units(best->found.point);
}

/// What an answer tells of an admissible damper beside its own motion, which moves the mass
/// farthest; `worst` is that of all pulses and springs.
void tell(Judged& answer, PulseMotion& motion, const PulseRequest& request,
          const PulseRegion& region, const DesignPoint& point, const FirstReturn& worst) {
  const auto& [problem, limits, options] = request;
  const double f = box_about(granted(point, limits), limits.shape).f.low;
  answer.stroke_worst = motion_at(region, f / region.f_unit()).peak * region.length_unit();
  add_practice(answer, problem, limits, motion, {motion.p, point.f, point.delta});
  if (problem.has_ranges()) {
    motion.worst = {worst.peak * region.length_unit(), worst.acceleration * region.f_unit(),
                    worst.time / problem.p};
  }
  answer.works_for = works_for(problem, limits, point.f, point.delta);
}

void judge(RegionAnswer& answer, const PulseRequest& request, const PulseRegion& region, double f,
           double delta) {
  const auto& [problem, limits, options] = request;
  const double unit_f = f / region.f_unit();
  const FirstReturn motion = motion_at(region, unit_f);
  answer.constraints = constraints_of(request, {f, delta, 0}, motion, region);
  answer.admissible = std::ranges::all_of(answer.constraints, &Constraint::satisfied);
  const PulseProblem shown = region.profile()->largest_peak(problem, unit_f);
  const Oscillator oscillator{shown.p, f, delta};
  answer.under_pulse = {shown.pulse, shown.p,
                        forced_response(oscillator, {}, excitation(shown.pulse))};
  answer.response = answer.under_pulse->response;
  answer.energies = motion_energies(oscillator, {}, excitation(shown.pulse));
  if (!*answer.admissible) {
    return;
  }
  // A point on an edge meets every requirement and has no tolerance.
  const double widest = region.tolerance_of(unit_f, delta / region.delta_unit()).value_or(0);
  answer.tolerance = even_tolerance(request, region, {f, delta, widest}, unit_f);
  // By this fraction of f an edge of the region lies inside that of the requirement, on either
  // side.
  constexpr double edge = 1e-12;
  answer.admissible = limits.tolerance <= widest + edge;
  tell(answer, *answer.under_pulse, request, region, {f, delta, *answer.tolerance}, motion);
}

}  // namespace

PulseRegion region_for(const PulseRequest& request) {
  require_valid(request.search);
  require_valid(request.problem, request.limits);
  return {request.problem, request.limits};
}

double even_tolerance(const PulseRequest& request, const PulseRegion& region,
                      const DesignPoint& point, double unit_f) {
  if (request.limits.shape == BoxShape{}) {
    return point.tolerance;
  }
  Limits even = request.limits;
  even.shape = {};
  return PulseRegion(region.profile(), request.problem, even)
      .tolerance_of(unit_f, point.delta / region.delta_unit())
      .value_or(0);
}

DesignResult around(const std::optional<PulseOptimum>& optimum, const PulseRequest& request,
                    const PulseRegion& region) {
  const auto& [problem, limits, options] = request;
  DesignResult result = without_finding(request, region, optimum);
  if (!optimum) {
    PulseMends found = mends(problem, limits, region.profile());
    result.mends = std::move(found.list);
    result.mends_cut_short = found.cut_short;
    result.criterion_mend = criterion_mend(problem, limits, region.profile());
    result.most_tolerant = most_tolerant(region, problem, limits);
  }
  return result;
}

RegionAnswer answer_under_pulse(const RegionRequest& asked) {
  const PulseRequest request = pulse_request(asked);
  const auto& [problem, limits, options] = request;
  const PulseRegion region = region_for(request);
  if (asked.f) {
    require_valid(Oscillator{problem.p, *asked.f, asked.delta.value_or(0)});
  }
  // Of several intervals, the region is the one with the most tolerant damper.
  RegionAnswer answer{around(search(region, options), request, region), {}};
  if (!asked.f) {
    return answer;
  }
  const double f = *asked.f;
  add_delta1(answer, problem, f);
  if (asked.delta) {
    judge(answer, request, region, f, *asked.delta);
  }
  return answer;
}

void add_finding(DesignResult& result, const PulseRequest& request, const PulseRegion& region,
                 const DesignPoint& point, double unit_f) {
  const auto& [problem, limits, options] = request;
  const FirstReturn worst = region.at(unit_f);
  const PulseProblem shown = region.profile()->largest_peak(problem, unit_f);
  const FirstReturn motion = first_return(shown.pulse, shown.p, unit_f);
  result.reduced_v0 = reduced_v0(shown.pulse, point.f);
  Found& found = result.finding.emplace(finding_under_pulse(shown, point, motion));
  found.constraints = constraints_of(request, point, worst, region);
  found.pulse->even_tolerance = even_tolerance(request, region, point, unit_f);
  found.energies = motion_energies({shown.p, point.f, point.delta}, {}, excitation(shown.pulse));
  tell(found, *found.pulse, request, region, point, worst);
  add_delta1(found, problem, point.f);
}

}  // namespace stillpoint::design
