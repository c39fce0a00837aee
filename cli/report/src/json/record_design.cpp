// SPDX-License-Identifier: MIT
#include "json/parts.hpp"

#include <stillpoint/report/record_design.hpp>

#include <cmath>
#include <cstddef>
#include <numbers>

namespace stillpoint::report {

namespace {

using nlohmann::ordered_json;

/// The period without friction; null without physical input.
ordered_json period_json(const Physical& physical, double p) {
  return seconds(physical, 2 * std::numbers::pi / p);
}

ordered_json task_json(const design::RecordDesignRequest& task, const Physical& physical) {
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
          {"hold", task.hold},
          {"notch_width", task.notch_width},
          {"notch_width_m", metres(physical, task.notch_width)},
          {"tolerance", task.tolerance}};
}

ordered_json damper_json(const design::SuiteDamper& damper, const Physical& physical) {
  const design::Scales scales = physical ? physical->scales : design::Scales();
  return {{"f", damper.f},
          {"friction_force_n", scales.friction_force_n(damper.f)},
          {"delta", damper.delta},
          {"delta_m", metres(physical, damper.delta)},
          {"energy_per_passage_j", scales.energy_per_passage_j(damper.delta)},
          {"p", damper.p},
          {"period_s", period_json(physical, damper.p)}};
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
          {"residual_m", metres(physical, figures.residual)}};
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

ordered_json search_json(const design::SuiteSearch& search) {
  return {{"library", "NLopt"},
          {"library_version", design::nlopt_version()},
          {"algorithm", search.algorithm},
          {"status", search.status},
          {"evaluations", search.evaluations},
          {"wall_time_s", search.wall_time_s},
          {"scan", {{"points", search.scan_points}, {"feasible", search.scan_feasible}}},
          {"interrupted", search.interrupted}};
}

ordered_json sensitivity_json(const design::Sensitivity& sensitivity, const Physical& physical) {
  return {
      {"tolerance", sensitivity.tolerance},
      {"samples", sensitivity.samples},
      {"admissible", sensitivity.admissible},
      {"worst_within", figures_json(sensitivity.worst, physical)},
      {"much_worse",
       or_null(
           sensitivity.much_worse,
           [&](const design::MuchWorse& there) -> ordered_json {
             return {{"change", there.change}, {"figures", figures_json(there.figures, physical)}};
           })},
      {"with_least_friction",
       or_null(sensitivity.with_least_friction,
               [&](const design::SuiteFigures& there) -> ordered_json {
                 return {{"f", design::least_friction}, {"figures", figures_json(there, physical)}};
               })}};
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
    const auto& [which, limit, figure, relaxed] = now;
    const auto nearest = result.nearest.figures.settled ? std::optional(figure) : std::nullopt;
    const Physical of_length =
        which == design::SuiteObjective::acceleration ? std::nullopt : physical;
    return {{"limit", kind_of(which).limit_field},     {"value", limit},
            {"value_m", metres(of_length, limit)},     {"nearest", nearest},
            {"nearest_m", metres(of_length, nearest)}, {"relaxed", relaxed},
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
                    {"design", nullptr},
                    {"reason", nullptr},
                    {"worst", nullptr},
                    {"records", ordered_json::array()},
                    {"search", search_json(result.search)},
                    {"sensitivity", nullptr},
                    {"notch_fault", or_null(report.notch_fault,
                                            [](const RealNotchFault& fault) {
                                              return ordered_json(fault.words);
                                            })},
                    {"cross_check", nullptr},
                    {"nearest", nullptr},
                    {"limits", shortfalls_json(result, physical)}};
  if (result.finding) {
    json["design"] = damper_json(result.finding->point.damper, physical);
    json["worst"] = figures_json(result.finding->point.figures, physical);
    json["records"] = records_json(result, physical);
    json["sensitivity"] = sensitivity_json(result.finding->sensitivity, physical);
    json["cross_check"] = check_json(result.finding->check);
  } else {
    json["reason"] = shortfall_sentence(report);
    json["nearest"] = {{"design", damper_json(result.nearest.damper, physical)},
                       {"worst", figures_json(result.nearest.figures, physical)}};
  }
  return json;
}

}  // namespace stillpoint::report
