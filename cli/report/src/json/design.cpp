// SPDX-License-Identifier: MIT
#include <stillpoint/report/report.hpp>
#include "choices.hpp"
#include "json/parts.hpp"
#include "sections.hpp"

namespace stillpoint::report {

namespace {

using nlohmann::ordered_json;

void add_pulse(ordered_json& task, const std::optional<design::Pulse>& pulse,
               const design::PulseRanges& ranges) {
  const auto& [k_low, lambda_high] = ranges;
  task["pulse"] = pulse ? ordered_json(design::name(*pulse)) : ordered_json(nullptr);
  task["k"] = pulse ? number(design::peak_load(*pulse)) : ordered_json(nullptr);
  task["k_range"] = nullptr;
  if (k_low) {
    task["k_range"] = {number(*k_low), task["k"]};
  }
  task["lambda"] = pulse ? number(design::angular_frequency(*pulse)) : ordered_json(nullptr);
  task["lambda_range"] = nullptr;
  if (lambda_high) {
    task["lambda_range"] = {task["lambda"], number(*lambda_high)};
  }
}

ordered_json design_point_json(const design::DesignResult& result) {
  const auto& [problem, limits, search, pulse, ranges] = result.request;
  const design::Finding& finding = *result.finding;
  const auto needs = delta_needs(result);
  const design::DesignPoint& point = finding.point;
  const bool shaped = limits.shape != design::BoxShape{};
  const auto within = [&](double below, double above) {
    return shaped ? ordered_json{number(1 - point.tolerance * below),
                                 number(1 + point.tolerance * above)}
                  : ordered_json(nullptr);
  };
  return {{"name", nullptr},
          {"f", number(point.f)},
          {"delta", number(point.delta)},
          {"tolerance", number(design::even_tolerance(result))},
          {"tolerance_f", within(limits.shape.f_low, limits.shape.f_high)},
          {"tolerance_delta", within(limits.shape.delta_low, limits.shape.delta_high)},
          {"arrival", finding.arrival ? ordered_json(*finding.arrival) : ordered_json(nullptr)},
          {"delta1_published", number(needs.published)},
          {"delta1_exact", number(needs.exact)}};
}

ordered_json strips_json(const std::vector<design::Strip>& strips) {
  ordered_json list = ordered_json::array();
  for (const design::Strip& strip : strips) {
    list.push_back({{"arrival", strip.arrival},
                    {"beta_min", number(strip.beta_min)},
                    {"f_lower", number(strip.f_lower)},
                    {"f_upper", number(strip.f_upper)},
                    {"tolerance", number(strip.tolerance)}});
  }
  return list;
}

ordered_json search_json(const design::DesignResult& result) {
  const design::SearchRecord& search = result.finding->search;
  const Optimum optimum = optimum_of(result);
  return {{"library", "NLopt"},
          {"library_version", design::nlopt_version()},
          {"algorithm", search.algorithm},
          {"status", search.status},
          {"evaluations", search.evaluations},
          {"wall_time_s", number(search.wall_time_s)},
          {"optimum", number(optimum.found)},
          {"optimum_along_f", number(optimum.along_f)}};
}

ordered_json cross_check_json(const design::CrossCheck& check) {
  ordered_json methods = ordered_json::array();
  for (const design::CheckMethod& method : check.methods) {
    methods.push_back({{"name", method.name},
                       {"tolerance", number(method.tolerance)},
                       {"peak_amplitude", number(method.peak_amplitude)},
                       {"peak_acceleration", number(method.peak_acceleration)},
                       {"stop_time", number(method.stop_time)},
                       {"arrival_speed", number(method.arrival_speed)},
                       {"half_cycles", count(method.half_cycles)},
                       {"stop_position", number(method.stop_position)},
                       {"relative_error", number(method.relative_error)},
                       {"wall_time_s", number(method.wall_time_s)},
                       {"decided", method.decided},
                       {"passed", method.passed}});
  }
  return {{"passed", check.passed}, {"methods", methods}};
}

/// How the design stands under its pulse.
ordered_json pulse_check_json(const design::PulseCheck& check) {
  ordered_json warnings = ordered_json::array();
  for (const design::PulseWarning warning : check.warnings) {
    warnings.push_back(name(warning));
  }
  ordered_json worst = nullptr;
  if (check.worst) {
    worst = {{"peak_amplitude", number(check.worst->peak)},
             {"peak_absolute_acceleration", number(check.worst->acceleration)},
             {"stop_time", number(check.worst->stop_time)}};
  }
  return {
      {"lambda", number(design::angular_frequency(check.pulse))},
      {"p", number(check.p)},
      {"worst", worst},
      {"shortness", number(check.shortness)},
      {"friction_ratio", number(check.friction_ratio)},
      {"equivalent_v0", number(check.start ? std::optional(check.start->speed) : std::nullopt)},
      {"equivalent_start", number(check.start ? std::optional(check.start->tau) : std::nullopt)},
      {"peak_error", number(check.peak_error)},
      {"stop_time_error", number(check.stop_time_error)},
      {"warnings", warnings},
      {"searched", number(check.searched)},
      {"bracketed", number(check.bracketed)},
      {"response", forced_json(check.response)}};
}

}  // namespace

namespace {

ordered_json file_of(const std::optional<Catalogue>& catalogue) {
  return catalogue ? ordered_json(spelled_out(catalogue->file)) : ordered_json(nullptr);
}

/// In metres where the input was.
ordered_json built_notch_json(const DesignReport& report) {
  if (!report.built_notch) {
    return nullptr;
  }
  const auto& [shape, friction, response, changes_nothing] = *report.built_notch;
  const auto metres = [&](const std::optional<double>& length) {
    return number(report.physical && length
                      ? std::optional(*length * report.physical->scales.length_m)
                      : std::nullopt);
  };
  return {{"width", number(shape.width)},
          {"width_m", metres(shape.width)},
          {"friction", number(friction)},
          {"hold", number(shape.hold)},
          {"changes_nothing", changes_nothing},
          {"outcome", name(response.outcome)},
          {"zero_passages", count(response.zero_passages)},
          {"stop_time", number(response.stop_time)},
          {"stop_position", number(response.stop_position)},
          {"stop_position_m", metres(response.stop_position)},
          {"peak_amplitude", number(response.peak_amplitude)},
          {"peak_absolute_acceleration", number(response.peak_absolute_acceleration)}};
}

}  // namespace

ordered_json json(const DesignReport& report) {
  const design::DesignResult& result = report.result;
  const auto& [problem, limits, search, pulse, ranges] = result.request;
  ordered_json task = task_json(problem, limits);
  add_pulse(task, pulse, ranges);
  if (pulse) {
    task["v0"] = number(result.reduced_v0);
  }
  task["objective"] = name(search.objective);
  task["algorithm"] = text_or_null(search.algorithm);
  task["catalogue"] = file_of(report.catalogue);
  task["trade_off"] = report.trade_offs ? ordered_json(*report.trade_offs) : ordered_json(nullptr);
  const PartTask parts{problem, limits, report.physical};
  ordered_json json{{"schema", "stillpoint/design-report/1"},
                    {"program", program_json()},
                    {"input", task},
                    {"region", region_fields(result)},
                    {"design", nullptr},
                    {"constraints", ordered_json::array()},
                    {"works_for", nullptr},
                    {"hits", nullptr},
                    {"practice", nullptr},
                    {"response", nullptr},
                    {"search", nullptr},
                    {"cross_check", nullptr},
                    {"pulse", nullptr},
                    {"built_notch", built_notch_json(report)},
                    {"catalogue", catalogue_json(report.catalogue, parts)},
                    {"trade_off", trade_off_json(report.trade_off, report.physical)},
                    {"physical", physical_json(report)}};
  if (result.finding) {
    const design::Finding& finding = *result.finding;
    json["design"] = design_point_json(result);
    json["design"]["name"] =
        report.catalogue ? ordered_json(report.catalogue->parts.front().part.name) : nullptr;
    json["constraints"] = constraints_json(finding.constraints);
    json["works_for"] = works_for_json(finding.works_for);
    if (!pulse) {
      json["hits"] = hits_json(shown_hits(problem, finding.point.f, finding.point.delta));
    }
    json["practice"] = practice_json(finding.practice);
    json["response"] =
        finding.pulse ? forced_json(finding.pulse->response) : response_json(finding.response);
    if (!report.catalogue) {
      json["search"] = search_json(report.result);
    }
    json["cross_check"] = cross_check_json(finding.cross_check);
    if (finding.pulse) {
      json["pulse"] = pulse_check_json(*finding.pulse);
    }
  }
  return json;
}

ordered_json json(const RegionReport& report) {
  const auto& [problem, limits, f, delta, pulse, ranges] = report.request;
  const design::RegionAnswer& answer = report.answer;
  ordered_json task = task_json(problem, limits);
  add_pulse(task, pulse, ranges);
  if (pulse) {
    task["v0"] = nullptr;
  }
  task["f"] = number(f);
  task["delta"] = number(delta);
  task["catalogue"] = file_of(report.catalogue);
  const bool hit_by = f && delta && !pulse;
  return {
      {"schema", "stillpoint/region-report/1"},
      {"program", program_json()},
      {"input", task},
      {"region", region_fields(answer)},
      {"strips", strips_json(answer.strips)},
      {"delta1_published", number(answer.delta1_published)},
      {"delta1_exact", number(answer.delta1_exact)},
      {"admissible", answer.admissible ? ordered_json(*answer.admissible) : ordered_json(nullptr)},
      {"tolerance", number(answer.tolerance)},
      {"arrival", answer.arrival ? ordered_json(*answer.arrival) : ordered_json(nullptr)},
      {"constraints", constraints_json(answer.constraints)},
      {"works_for", works_for_json(answer.works_for)},
      {"hits", hit_by ? hits_json(shown_hits(problem, *f, *delta)) : ordered_json(nullptr)},
      {"practice", practice_json(answer.practice)},
      {"catalogue", catalogue_json(report.catalogue, {problem, limits, report.physical})},
      {"physical", physical_json(report)}};
}

}  // namespace stillpoint::report
