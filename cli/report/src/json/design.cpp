// SPDX-License-Identifier: MIT
#include <stillpoint/report/report.hpp>
#include "choices.hpp"
#include "design_parts.hpp"
#include "json/motion_fields.hpp"
#include "json/parts.hpp"
#include "sections.hpp"

namespace stillpoint::report {

namespace {

using nlohmann::ordered_json;

void add_pulse(ordered_json& task, const std::optional<design::Pulse>& pulse,
               const design::PulseRanges& ranges) {
  const auto& [k_low, lambda_high] = ranges;
  for (const char* const field : {"pulse", "k", "k_range", "lambda", "lambda_range"}) {
    task[field] = nullptr;
  }
  if (pulse) {
    task["pulse"] = design::name(*pulse);
    task["k"] = design::peak_load(*pulse);
    task["lambda"] = design::angular_frequency(*pulse);
  }
  if (k_low) {
    task["k_range"] = {*k_low, task["k"]};
  }
  if (lambda_high) {
    task["lambda_range"] = {task["lambda"], *lambda_high};
  }
}

ordered_json design_point_json(const DesignReport& report) {
  const design::DesignResult& result = report.result;
  const design::BoxShape& shape = result.request.limits.shape;
  const design::Found& finding = *result.finding;
  const auto needs = delta_needs(result);
  const auto& [f, delta, tolerance] = finding.point;
  return {{"name", or_null(report.catalogue,
                           [](const Catalogue& given) { return given.parts.front().part.name; })},
          {"f", f},
          {"delta", delta},
          {"tolerance", design::even_tolerance(result)},
          {"tolerance_f", side_json(shape, tolerance, shape.f_low, shape.f_high)},
          {"tolerance_delta", side_json(shape, tolerance, shape.delta_low, shape.delta_high)},
          {"arrival", finding.arrival},
          {"delta1_published", needs.published},
          {"delta1_exact", needs.exact}};
}

ordered_json strip_json(const design::Strip& strip) {
  return {{"arrival", strip.arrival},
          {"beta_min", strip.beta_min},
          {"f_lower", strip.f_lower},
          {"f_upper", strip.f_upper},
          {"tolerance", strip.tolerance}};
}

ordered_json search_json(const design::SearchRecord& search, const design::DesignResult& result) {
  const Optimum optimum = optimum_of(result);
  return {{"library", "NLopt"},
          {"library_version", design::nlopt_version()},
          {"algorithm", search.algorithm},
          {"status", search.status},
          {"evaluations", search.evaluations},
          {"wall_time_s", search.wall_time_s},
          {"optimum", optimum.found},
          {"optimum_along_f", optimum.along_f}};
}

ordered_json method_json(const design::CheckMethod& method) {
  return {{"name", method.name},
          {"tolerance", method.tolerance},
          {"peak_amplitude", method.peak_amplitude},
          {"peak_acceleration", method.peak_acceleration},
          {"stop_time", method.stop_time},
          {"arrival_speed", method.arrival_speed},
          {"half_cycles", count(method.half_cycles)},
          {"stop_position", method.stop_position},
          {"relative_error", method.relative_error},
          {"wall_time_s", method.wall_time_s},
          {"decided", method.decided},
          {"passed", method.passed}};
}

/// The design under its pulse.
ordered_json pulse_check_json(const design::PulseCheck& check, const Optimum& optimum) {
  const auto worst = [](const auto& figures) -> ordered_json {
    return {{"peak_amplitude", figures.peak},
            {"peak_absolute_acceleration", figures.acceleration},
            {"stop_time", figures.stop_time}};
  };
  return {{"lambda", design::angular_frequency(check.pulse)},
          {"p", check.p},
          {"worst", or_null(check.worst, worst)},
          {"shortness", check.shortness},
          {"friction_ratio", check.friction_ratio},
          {"equivalent_v0", or_null(check.start, [](const auto& start) { return start.speed; })},
          {"equivalent_start", or_null(check.start, [](const auto& start) { return start.tau; })},
          {"peak_error", check.peak_error},
          {"stop_time_error", check.stop_time_error},
          {"warnings", list_json(check.warnings, [](auto warning) { return name(warning); })},
          {"searched", optimum.found},
          {"bracketed", optimum.along_f},
          {"response", response_json(check.response)}};
}

ordered_json file_of(const std::optional<Catalogue>& catalogue) {
  return or_null(catalogue, [](const Catalogue& given) { return spelled_out(given.file); });
}

/// Of ranges; null without any.
ordered_json tried_json(const design::TriedMotion* now, const Physical& physical) {
  if (now == nullptr) {
    return nullptr;
  }
  const auto& [v0, pulse, p, response, from_inside] = *now;
  ordered_json json;
  json["v0"] = pulse ? ordered_json() : ordered_json(v0);
  json["k"] = or_null(pulse, [](const auto& of) { return design::peak_load(of); });
  json["lambda"] = or_null(pulse, [](const auto& of) { return design::angular_frequency(of); });
  json["p"] = p;
  json["from_inside"] = from_inside;
  json["stop_position"] = now->rest();
  json["stop_position_m"] = metres(physical, now->rest());
  json["peak_amplitude"] = response.peak_amplitude;
  json["peak_m"] = metres(physical, response.peak_amplitude);
  json["peak_absolute_acceleration"] = response.peak_absolute_acceleration;
  return json;
}

ordered_json built_notch_json(const design::BuiltNotch& built, const Physical& physical) {
  const auto& [shape, friction, response, changes_nothing, from_start, worst, holds] = built;
  return {{"width", shape.width},
          {"width_m", metres(physical, shape.width)},
          {"friction", friction},
          {"hold", shape.hold},
          {"changes_nothing", changes_nothing},
          {"outcome", name(response.outcome)},
          {"zero_passages", count(response.zero_passages)},
          {"stop_time", response.stop_time},
          {"stop_position", response.stop_position},
          {"stop_position_m", metres(physical, response.stop_position)},
          {"peak_amplitude", response.peak_amplitude},
          {"peak_absolute_acceleration", response.peak_absolute_acceleration},
          {"from_start", or_null(from_start,
                                 [&](const ForcedResponse& now) -> ordered_json {
                                   return {{"stop_position", now.stop_position},
                                           {"stop_position_m", metres(physical, now.stop_position)},
                                           {"peak_amplitude", now.peak_amplitude},
                                           {"peak_absolute_acceleration",
                                            now.peak_absolute_acceleration}};
                                 })},
          {"farthest_rest", tried_json(worst ? &worst->farthest : nullptr, physical)},
          {"largest_peak", tried_json(worst ? &worst->peak : nullptr, physical)},
          {"largest_acceleration", tried_json(worst ? &worst->felt : nullptr, physical)}};
}

/// At the ends of the ranges; null without any.
ordered_json practice_worst_json(const ShownTask& task, const std::optional<design::Practice>& own,
                                 double f, double delta) {
  const ToldPractice told = told_practice(task, own, f, delta);
  return told.at_ends ? practice_json(told.lines) : nullptr;
}

/// For the reports of a design and of a region.
template <class Report>
ordered_json parts_json(const Report& report) {
  return or_null(report.catalogue,
                 [&](const Catalogue& given) { return catalogue_json(given, task_of(report)); });
}

void add_finding(ordered_json& json, const DesignReport& report) {
  const design::DesignResult& result = report.result;
  const design::Found& now = *result.finding;
  json["design"] = design_point_json(report);
  json["constraints"] = list_json(now.constraints, constraint_json);
  const auto& [problem, limits, search, pulse, ranges] = result.request;
  json["works_for"] = served_json(now.works_for, pulse.has_value());
  json["hits"] = hits_json(problem, pulse, ranges, now.point.f, now.point.delta);
  json["practice"] = practice_json(
      now.practice, design::impulses({problem.p, now.point.f, now.point.delta}, now.response));
  json["practice_worst"] =
      practice_worst_json(task_of(report), now.practice, now.point.f, now.point.delta);
  if (now.pulse) {
    json["response"] = response_json(now.pulse->response);
    json["pulse"] = pulse_check_json(*now.pulse, optimum_of(result));
  } else {
    json["response"] = response_json(now.response);
  }
  if (now.search) {
    json["search"] = search_json(*now.search, result);
  }
  json["cross_check"] = {{"passed", now.cross_check.passed},
                         {"methods", list_json(now.cross_check.methods, method_json)}};
}

ordered_json notch_fault_json(const DesignReport& report) {
  const std::string words = notch_sentence(report);
  return words.empty() ? ordered_json(nullptr) : ordered_json(words);
}

}  // namespace

ordered_json json(const DesignReport& report) {
  const design::DesignResult& result = report.result;
  const auto& [problem, limits, search, pulse, ranges] = result.request;
  ordered_json task = task_json(problem, limits);
  add_pulse(task, pulse, ranges);
  if (pulse) {
    task["v0"] = result.reduced_v0;
  }
  task["objective"] = name(search.objective);
  task["algorithm"] = search.algorithm;
  task["catalogue"] = file_of(report.catalogue);
  task["trade_off"] = report.trade_offs;
  ordered_json json{{"schema", "stillpoint/design-report/1"},
                    {"program", program_json()},
                    {"input", task},
                    {"region", region_fields(result)}};
  for (const char* const field : {"design", "constraints", "works_for", "hits", "practice",
                                  "practice_worst", "response", "search", "cross_check", "pulse"}) {
    json[field] = nullptr;
  }
  json["constraints"] = ordered_json::array();
  if (result.finding) {
    add_finding(json, report);
  }
  json["built_notch"] = or_null(report.built_notch, [&](const design::BuiltNotch& built) {
    return built_notch_json(built, report.physical);
  });
  json["notch_fault"] = notch_fault_json(report);
  json["catalogue"] = parts_json(report);
  json["trade_off"] = or_null(
      report.trade_off, [&](const auto& front) { return trade_off_json(front, report.physical); });
  json["physical"] = value_json(physical_of(report));
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
  task["f"] = f;
  task["delta"] = delta;
  task["catalogue"] = file_of(report.catalogue);
  return {{"schema", "stillpoint/region-report/1"},
          {"program", program_json()},
          {"input", task},
          {"region", region_fields(answer)},
          {"strips", list_json(answer.strips, strip_json)},
          {"delta1_published", answer.delta1_published},
          {"delta1_exact", answer.delta1_exact},
          {"admissible", answer.admissible},
          {"tolerance", answer.tolerance},
          {"arrival", answer.arrival},
          {"constraints", list_json(answer.constraints, constraint_json)},
          {"works_for", served_json(answer.works_for, pulse.has_value())},
          {"hits", f && delta ? hits_json(problem, pulse, ranges, *f, *delta) : nullptr},
          {"practice", practice_json(answer.practice,
                                     answer.practice ? design::impulses({problem.p, *f, *delta},
                                                                        *answer.response)
                                                     : std::vector<double>())},
          {"practice_worst",
           practice_worst_json(task_of(report), answer.practice, f.value_or(0), delta.value_or(0))},
          {"notch_fault", notch_fault_json(as_design(report))},
          {"catalogue", parts_json(report)},
          {"physical", value_json(physical_of(report))}};
}

}  // namespace stillpoint::report
