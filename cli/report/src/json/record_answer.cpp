// SPDX-License-Identifier: MIT
#include "json/answer_fields.hpp"

#include <algorithm>

namespace stillpoint::report {

namespace {

Interval factors(const design::Spread& spread) {
  return {1 - spread.below, 1 + spread.above};
}

IfRange unless_exact(const Interval& side) {
  return side.low < side.high ? std::optional(side) : std::nullopt;
}

AskedTask asked_task(const design::RecordDesignRequest& task) {
  const auto& [f, delta, width, period] = task.tolerance;
  AskedTask asked{.beta = task.limits.peak,
                  .residual = task.limits.residual,
                  .jump_max = task.limits.jump,
                  .hold = task.hold,
                  .p_range = task.p,
                  .tolerance_f = factors(f),
                  .tolerance_delta = factors(delta),
                  .tolerance_width = factors(width),
                  .tolerance_period = factors(period),
                  .f_range = task.f,
                  .delta_range = task.delta,
                  .notch_width_range = task.width,
                  .tolerance = std::max({f.below, f.above, delta.below, delta.above}),
                  .objective = name(task.objective)};
  asked.limits.f_max = task.f_max;
  asked.limits.delta_max = task.delta_max;
  asked.limits.acceleration_max = task.limits.acceleration;
  if (task.width && task.width->low == task.width->high) {
    asked.notch_width = task.width->low;
  }
  return asked;
}

BoxedDamper boxed_damper(const design::RecordFinding& finding, const IfReal& tolerance) {
  const design::SuiteBox& box = finding.box;
  return {finding.point.damper,
          {unless_exact(box.f), unless_exact(box.delta), unless_exact(box.p),
           unless_exact({turn(box.p.high), turn(box.p.low)}), unless_exact(box.width), box.samples,
           false},
          tolerance};
}

/// In the order of design::suite_figure_kinds. The motion that has the worst is known of one record
/// alone.
WorstInBox shown_worst(const design::SuiteBox& box, const Name& motion) {
  const auto at = [&](std::size_t kind) { return WorstAt{box.of.at(kind), motion}; };
  return {worst_of(box.worst), {at(0), at(1), at(2), {}, at(3)}};
}

std::vector<ShownLoaded> motions_of(const design::RecordDesign& result) {
  std::vector<ShownLoaded> motions;
  for (std::size_t i = 0; i < result.finding->responses.size(); ++i) {
    motions.push_back({{},
                       result.finding->point.damper.p,
                       {},
                       ShownResponse(result.finding->responses[i]),
                       &result.request.records[i]});
  }
  return motions;
}

}  // namespace

ShownAnswer shown(const RecordDesignReport& report) {
  const design::RecordDesign& result = report.result;
  const design::RecordDesignRequest& request = result.request;
  ShownCase only{.load = {"records", request.records.size()}, .combine = request.combine};
  ShownAnswer now{.units = report.physical,
                  .findings = findings(report),
                  .verdict = verdict(report),
                  .input = asked_task(request),
                  .constraints = result.constraints,
                  .mends = result.mends,
                  .search = &result.search};
  if (const auto& finding = result.finding) {
    now.design = boxed_damper(*finding, result.largest_tolerance);
    only.nominal = worst_of(finding->point.figures);
    only.worst = shown_worst(finding->box, request.records.size() == 1
                                               ? std::optional(request.records.front().name)
                                               : std::nullopt);
    only.motions = motions_of(result);
    now.outlook = &finding->outlook;
    now.cross_check = &finding->cross_check;
  } else {
    now.largest_tolerance = result.largest_tolerance;
    now.nearest = &result.nearest;
  }
  now.cases.push_back(std::move(only));
  return now;
}

}  // namespace stillpoint::report
