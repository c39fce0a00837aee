// SPDX-License-Identifier: MIT
#include "json/answer_fields.hpp"

#include <stillpoint/report/record_design.hpp>

#include <algorithm>
#include <array>
#include <cstddef>
#include <utility>

namespace stillpoint::report {

namespace {

/// A figure of records as a condition, in the order of design::suite_figure_kinds.
struct Condition {
  std::string_view name;
  std::string_view variable;
  std::string_view input;
  std::optional<WorstAt> OfFigures<WorstAt>::*of;
};
constexpr std::array<Condition, design::suite_figure_kinds.size()> conditions{
    {{"amplitude", "peak", "beta", &OfFigures<WorstAt>::peak},
     {"acceleration", "acceleration", "acceleration_max", &OfFigures<WorstAt>::acceleration},
     {"residual", "residual", "residual", &OfFigures<WorstAt>::residual},
     {"jump", "jump", "jump_max", &OfFigures<WorstAt>::jump}}};

Interval factors(const design::Spread& spread) {
  return {1 - spread.below, 1 + spread.above};
}

IfRange unless_exact(const Interval& side) {
  return side.low < side.high ? std::optional(side) : std::nullopt;
}

Worst worst_of(const design::SuiteFigures& figures) {
  return {figures.peak, figures.acceleration, figures.residual, {}, figures.jump};
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

/// The motion that has the worst is known of one record alone.
WorstInBox shown_worst(const design::SuiteBox& box, const Name& motion) {
  WorstInBox worst{worst_of(box.worst), {}};
  for (std::size_t k = 0; k < conditions.size(); ++k) {
    worst.of.*conditions.at(k).of = WorstAt{box.of.at(k), motion};
  }
  return worst;
}

std::vector<ShownLoaded> motions_of(const design::RecordDesign& result, const Physical& physical) {
  std::vector<ShownLoaded> motions;
  for (std::size_t i = 0; i < result.finding->responses.size(); ++i) {
    const design::SuiteRecord& record = result.request.records[i];
    const ShownResponse response(result.finding->responses[i]);
    motions.push_back({.what = record.name,
                       .p = result.finding->point.damper.p,
                       .scale = record.scale,
                       .pga = design::peak_load(record),
                       .response = response,
                       .physical = twins_of(physical, response)});
  }
  return motions;
}

ShownConstraint constraint(std::size_t kind, double limit, const IfReal& value) {
  return {{},
          conditions.at(kind).name,
          conditions.at(kind).variable,
          "<=",
          value,
          value ? std::optional(limit - *value) : std::nullopt,
          limit,
          value && *value <= limit};
}

std::vector<ShownConstraint> kept(const design::SuiteLimits& limits,
                                  const design::SuiteFigures& worst) {
  std::vector<ShownConstraint> shown;
  for (std::size_t k = 0; k < conditions.size(); ++k) {
    const design::SuiteFigureKind& kind = design::suite_figure_kinds.at(k);
    if (const auto& limit = limits.*kind.limit) {
      shown.push_back(constraint(k, *limit, worst.*kind.value));
    }
  }
  return shown;
}

/// What the nearest damper violates, and the limits that alone would have to change.
void add_shortfalls(ShownAnswer& now, const design::RecordDesign& result) {
  for (const design::SuiteShortfall& of : result.shortfalls) {
    const auto kind = static_cast<std::size_t>(of.kind - design::suite_figure_kinds.data());
    now.constraints.push_back(constraint(
        kind, of.limit, result.nearest.figures.settled ? std::optional(of.nearest) : std::nullopt));
    now.constraints.back().motion = result.request.records[of.record].name;
    if (of.relaxed) {
      now.mends.push_back({{conditions.at(kind).input, *of.relaxed, true}});
    }
  }
}

ShownSearch shown_search(const design::SuiteSearchCost& search) {
  return {"stillpoint",
          program_version(),
          "boxes",
          search.interrupted ? "INTERRUPTED" : "SUCCESS",
          search.evaluations,
          search.wall_time_s,
          {},
          Scan{search.scan_points, search.scan_feasible},
          search.interrupted};
}

ShownCheck shown_check(const design::SuiteCheck& check) {
  return {check.passed,
          {{"runge_kutta", check.tolerance, check.relative_error, check.wall_time_s, true,
            check.passed, nullptr, check.records}}};
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
                  .search = shown_search(result.search)};
  if (const auto& finding = result.finding) {
    now.design = boxed_damper(*finding, result.largest_tolerance);
    only.nominal = worst_of(finding->point.figures);
    only.worst = shown_worst(finding->box, request.records.size() == 1
                                               ? std::optional(request.records.front().name)
                                               : std::nullopt);
    only.motions = motions_of(result, report.physical);
    now.constraints = kept(request.limits, finding->box.worst);
    now.outlook = finding->outlook;
    now.cross_check = shown_check(finding->check);
  } else {
    now.largest_tolerance = result.largest_tolerance;
    now.nearest = {result.nearest.damper, result.nearest.figures.settled
                                              ? std::optional(worst_of(result.nearest.figures))
                                              : std::nullopt};
    add_shortfalls(now, result);
  }
  now.cases.push_back(std::move(only));
  return now;
}

}  // namespace stillpoint::report
