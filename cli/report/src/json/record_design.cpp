// SPDX-License-Identifier: MIT
#include "json/parts.hpp"

#include "record_design_parts.hpp"

#include <stillpoint/report/findings.hpp>
#include <stillpoint/report/record_design.hpp>

#include <algorithm>
#include <array>
#include <cstddef>
#include <numbers>
#include <optional>
#include <string>
#include <string_view>

namespace stillpoint::report {

namespace {

using nlohmann::ordered_json;

/// In the order of design::suite_figure_kinds.
constexpr std::array<std::string_view, design::suite_figure_kinds.size()> figure_fields{
    "peak_amplitude", "peak_absolute_acceleration", "residual", "jump"};

/// The period without friction; null without physical input.
ordered_json period_json(const Physical& physical, double p) {
  return seconds(physical, 2 * std::numbers::pi / p);
}

ordered_json factors_json(const design::Spread& spread) {
  return {1 - spread.below, 1 + spread.above};
}

std::optional<double> metres_per_second(const Physical& physical,
                                        const std::optional<double>& speed) {
  return physical && speed ? std::optional(*speed * physical->scales.velocity_m_per_s)
                           : std::nullopt;
}

/// Null of what is exact.
ordered_json side_json(const Interval& range, double factor) {
  return range.low < range.high ? ordered_json{range.low * factor, range.high * factor}
                                : ordered_json();
}

ordered_json box_json(const design::SuiteBox& box, const Physical& physical) {
  const double metre = physical ? physical->scales.length_m : 1;
  const double turn = 2 * std::numbers::pi * (physical ? physical->scales.time_s : 1);
  const Interval periods{turn / box.p.high, turn / box.p.low};
  return {{"f", side_json(box.f, 1)},
          {"delta", side_json(box.delta, 1)},
          {"delta_m", physical ? side_json(box.delta, metre) : ordered_json()},
          {"p", side_json(box.p, 1)},
          {"period_s", physical ? side_json(periods, 1) : ordered_json()},
          {"notch_width", side_json(box.width, 1)},
          {"notch_width_m", physical ? side_json(box.width, metre) : ordered_json()},
          {"samples", box.samples},
          {"exact", false}};
}

ordered_json task_json(const design::RecordDesignRequest& task, const Physical& physical) {
  const std::optional<double> width = task.width && task.width->low == task.width->high
                                          ? std::optional(task.width->low)
                                          : std::nullopt;
  return {{"records", task.records.size()},
          {"p_range", interval_json(task.p)},
          {"f_range", interval_json(task.f.value())},
          {"delta_range", interval_json(task.delta.value())},
          {"objective", name(task.objective)},
          {"combine", name(task.combine.value())},
          {"beta", task.limits.peak},
          {"max_displacement_m", metres(physical, task.limits.peak)},
          {"residual", task.limits.residual},
          {"residual_m", metres(physical, task.limits.residual)},
          {"acceleration_max", task.limits.acceleration},
          {"jump_max", task.limits.jump},
          {"jump_max_m_per_s", metres_per_second(physical, task.limits.jump)},
          {"hold", task.hold},
          {"notch_width", width},
          {"notch_width_m", metres(physical, width)},
          {"notch_width_range",
           or_null(task.width, [](const Interval& range) { return interval_json(range); })},
          {"tolerance", std::max({task.tolerance.f.below, task.tolerance.f.above,
                                  task.tolerance.delta.below, task.tolerance.delta.above})},
          {"tolerance_f", factors_json(task.tolerance.f)},
          {"tolerance_delta", factors_json(task.tolerance.delta)},
          {"tolerance_width", factors_json(task.tolerance.width)},
          {"tolerance_period", factors_json(task.tolerance.period)}};
}

ordered_json damper_json(const design::SuiteDamper& damper, const Physical& physical) {
  const design::Scales scales = physical ? physical->scales : design::Scales();
  const auto width = damper.width > 0 ? std::optional(damper.width) : std::nullopt;
  return {{"f", damper.f},
          {"friction_force_n", scales.friction_force_n(damper.f)},
          {"delta", damper.delta},
          {"delta_m", metres(physical, damper.delta)},
          {"energy_per_passage_j", scales.energy_per_passage_j(damper.delta)},
          {"p", damper.p},
          {"period_s", period_json(physical, damper.p)},
          {"notch_width", width},
          {"notch_width_m", metres(physical, width)}};
}

/// Null where a motion never rests.
ordered_json figures_json(const design::SuiteFigures& figures, const Physical& physical) {
  if (!figures.settled) {
    return nullptr;
  }
  return {{"peak_amplitude", figures.peak},
          {"peak_m", metres(physical, figures.peak)},
          {"peak_absolute_acceleration", figures.acceleration},
          {"residual", figures.residual},
          {"residual_m", metres(physical, figures.residual)},
          {"jump", figures.jump},
          {"jump_m_per_s", metres_per_second(physical, figures.jump)}};
}

ordered_json records_json(const design::RecordDesign& result, const Physical& physical) {
  ordered_json list = ordered_json::array();
  for (std::size_t i = 0; i < result.finding->responses.size(); ++i) {
    const design::SuiteRecord& record = result.request.records[i];
    const ForcedResponse& response = result.finding->responses[i];
    ordered_json& json = list.emplace_back(ordered_json{
        {"file", record.name}, {"scale", record.scale}, {"pga", design::peak_load(record)}});
    json.update(figures_json(design::suite_figures(response), physical));
    json["outcome"] = name(response.outcome);
    json["locked_from"] = response.locked_from;
    json["locked_from_s"] = seconds(physical, response.locked_from);
    json["largest_load_while_locked"] = response.largest_load_while_locked;
    json["decision_margin"] = response.decision_margin;
  }
  return list;
}

ordered_json search_json(const design::SuiteSearchCost& search) {
  return {{"library", "stillpoint"},
          {"algorithm", "boxes"},
          {"status", search.interrupted ? "INTERRUPTED" : "SUCCESS"},
          {"evaluations", search.evaluations},
          {"wall_time_s", search.wall_time_s},
          {"scan", {{"points", search.scan_points}, {"feasible", search.scan_feasible}}},
          {"interrupted", search.interrupted}};
}

ordered_json outlook_json(const design::SuiteOutlook& outlook, const Physical& physical) {
  return {{"off", design::SuiteOutlook::off},
          {"period", figures_json(outlook.period, physical)},
          {"scale", figures_json(outlook.scale, physical)}};
}

ordered_json check_json(const design::SuiteCheck& check) {
  ordered_json records =
      list_json(check.records, [](const design::SuiteCheckRow& row) -> ordered_json {
        return {{"peak_amplitude", row.peak},
                {"peak_absolute_acceleration", row.acceleration},
                {"residual", row.residual},
                {"relative_error", row.relative_error}};
      });
  return {{"passed", check.passed},
          {"methods",
           {{{"name", "runge_kutta"},
             {"tolerance", check.tolerance},
             {"relative_error", check.relative_error},
             {"wall_time_s", check.wall_time_s},
             {"records", records}}}}};
}

ordered_json shortfalls_json(const design::RecordDesign& result, const Physical& physical) {
  return list_json(result.shortfalls, [&](const design::SuiteShortfall& now) -> ordered_json {
    const auto& [kind, limit, figure, record, relaxed] = now;
    const auto nearest = result.nearest.figures.settled ? std::optional(figure) : std::nullopt;
    const bool is_length =
        kind->objective && kind->objective != design::SuiteObjective::acceleration;
    const Physical of_length = is_length ? physical : std::nullopt;
    return {{"limit", kind->limit_field},
            {"value", limit},
            {"value_m", metres(of_length, limit)},
            {"nearest", nearest},
            {"nearest_m", metres(of_length, nearest)},
            {"record", result.request.records[record].name},
            {"relaxed", relaxed},
            {"relaxed_m", metres(of_length, relaxed)}};
  });
}

}  // namespace

ordered_json json(const RecordDesignReport& report) {
  const design::RecordDesign& result = report.result;
  const Physical& physical = report.physical;
  ordered_json json{{"schema", "stillpoint/record-design-report/1"},
                    {"program", program_json()},
                    {"input", task_json(result.request, physical)},
                    {"verdict", verdict(report)},
                    {"findings", findings_json(result.findings, physical)},
                    {"design", nullptr},
                    {"worst", nullptr},
                    {"records", ordered_json::array()},
                    {"search", search_json(result.search)},
                    {"nominal", nullptr},
                    {"outlook", nullptr},
                    {"largest_tolerance", result.largest_tolerance},
                    {"cross_check", nullptr},
                    {"nearest", nullptr},
                    {"limits", shortfalls_json(result, physical)}};
  if (result.finding) {
    const design::RecordFinding& finding = *result.finding;
    json["design"] = damper_json(finding.point.damper, physical);
    json["design"]["tolerance"] = result.largest_tolerance;
    json["design"]["box"] = box_json(finding.box, physical);
    json["worst"] = figures_json(finding.box.worst, physical);
    ordered_json& of = json["worst"]["of"];
    for (std::size_t k = 0; k < design::suite_figure_kinds.size(); ++k) {
      of[std::string(figure_fields.at(k))] = damper_json(finding.box.of.at(k), physical);
    }
    json["nominal"] = figures_json(finding.point.figures, physical);
    json["records"] = records_json(result, physical);
    json["outlook"] = outlook_json(finding.outlook, physical);
    json["cross_check"] = check_json(finding.check);
  } else {
    json["nearest"] = {{"design", damper_json(result.nearest.damper, physical)},
                       {"worst", figures_json(result.nearest.figures, physical)}};
  }
  return json;
}

}  // namespace stillpoint::report
