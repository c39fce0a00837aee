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
  task["pulse"] = or_null(pulse, [](const auto& given) { return design::name(given); });
  task["k"] = or_null(pulse, [](const auto& given) { return number(design::peak_load(given)); });
  task["k_range"] = nullptr;
  if (k_low) {
    task["k_range"] = {number(*k_low), task["k"]};
  }
  task["lambda"] =
      or_null(pulse, [](const auto& given) { return number(design::angular_frequency(given)); });
  task["lambda_range"] = nullptr;
  if (lambda_high) {
    task["lambda_range"] = {task["lambda"], number(*lambda_high)};
  }
}

ordered_json design_point_json(const DesignReport& report) {
  const design::DesignResult& result = report.result;
  const design::BoxShape& shape = result.request.limits.shape;
  const design::Finding& finding = *result.finding;
  const auto needs = delta_needs(result);
  const auto& [f, delta, tolerance] = finding.point;
  return {{"name", or_null(report.catalogue,
                           [](const Catalogue& given) { return given.parts.front().part.name; })},
          {"f", number(f)},
          {"delta", number(delta)},
          {"tolerance", number(design::even_tolerance(result))},
          {"tolerance_f", side_json(shape, tolerance, shape.f_low, shape.f_high)},
          {"tolerance_delta", side_json(shape, tolerance, shape.delta_low, shape.delta_high)},
          {"arrival", or_null(finding.arrival)},
          {"delta1_published", number(needs.published)},
          {"delta1_exact", number(needs.exact)}};
}

ordered_json strips_json(const std::vector<design::Strip>& strips) {
  return list_json(strips, [](const design::Strip& strip) -> ordered_json {
    return {{"arrival", strip.arrival},
            {"beta_min", number(strip.beta_min)},
            {"f_lower", number(strip.f_lower)},
            {"f_upper", number(strip.f_upper)},
            {"tolerance", number(strip.tolerance)}};
  });
}

ordered_json search_json(const design::SearchRecord& search, const design::DesignResult& result) {
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
  const auto method_json = [](const design::CheckMethod& method) -> ordered_json {
    return {{"name", method.name},
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
            {"passed", method.passed}};
  };
  return {{"passed", check.passed}, {"methods", list_json(check.methods, method_json)}};
}

/// The design under its pulse.
ordered_json pulse_check_json(const design::PulseCheck& check) {
  const auto worst = [](const auto& figures) -> ordered_json {
    return {{"peak_amplitude", number(figures.peak)},
            {"peak_absolute_acceleration", number(figures.acceleration)},
            {"stop_time", number(figures.stop_time)}};
  };
  return {{"lambda", number(design::angular_frequency(check.pulse))},
          {"p", number(check.p)},
          {"worst", or_null(check.worst, worst)},
          {"shortness", number(check.shortness)},
          {"friction_ratio", number(check.friction_ratio)},
          {"equivalent_v0",
           or_null(check.start, [](const auto& start) { return number(start.speed); })},
          {"equivalent_start",
           or_null(check.start, [](const auto& start) { return number(start.tau); })},
          {"peak_error", number(check.peak_error)},
          {"stop_time_error", number(check.stop_time_error)},
          {"warnings", list_json(check.warnings, [](auto warning) { return name(warning); })},
          {"searched", number(check.searched)},
          {"bracketed", number(check.bracketed)},
          {"response", forced_json(check.response)}};
}

ordered_json file_of(const std::optional<Catalogue>& catalogue) {
  return or_null(catalogue, [](const Catalogue& given) { return spelled_out(given.file); });
}

ordered_json built_notch_json(const design::BuiltNotch& built, const Physical& physical) {
  const auto& [shape, friction, response, changes_nothing] = built;
  return {{"width", number(shape.width)},
          {"width_m", metres(physical, shape.width)},
          {"friction", number(friction)},
          {"hold", number(shape.hold)},
          {"changes_nothing", changes_nothing},
          {"outcome", name(response.outcome)},
          {"zero_passages", count(response.zero_passages)},
          {"stop_time", number(response.stop_time)},
          {"stop_position", number(response.stop_position)},
          {"stop_position_m", metres(physical, response.stop_position)},
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
  task["algorithm"] = or_null(search.algorithm);
  task["catalogue"] = file_of(report.catalogue);
  task["trade_off"] = or_null(report.trade_offs);
  const auto found = [&](const auto& make) { return or_null(result.finding, make); };
  using design::Finding;
  return {
      {"schema", "stillpoint/design-report/1"},
      {"program", program_json()},
      {"input", task},
      {"region", region_fields(result)},
      {"design", found([&](const Finding&) { return design_point_json(report); })},
      {"constraints", constraints_json(result.finding ? result.finding->constraints
                                                      : std::vector<design::Constraint>())},
      {"works_for",
       found([](const Finding& now) { return or_null(now.works_for, works_for_json); })},
      {"hits", found([&](const Finding& now) {
         return now.pulse
                    ? ordered_json(nullptr)
                    : hits_json(shown_hits(result.request.problem, now.point.f, now.point.delta));
       })},
      {"practice", found([](const Finding& now) { return or_null(now.practice, practice_json); })},
      {"response", found([](const Finding& now) {
         return now.pulse ? forced_json(now.pulse->response) : response_json(now.response);
       })},
      {"search", found([&](const Finding& now) {
         return or_null(now.search, [&](const design::SearchRecord& record) {
           return search_json(record, result);
         });
       })},
      {"cross_check", found([](const Finding& now) { return cross_check_json(now.cross_check); })},
      {"pulse", found([](const Finding& now) { return or_null(now.pulse, pulse_check_json); })},
      {"built_notch",
       or_null(report.built_notch,
               [&](const auto& built) { return built_notch_json(built, report.physical); })},
      {"catalogue",
       or_null(report.catalogue,
               [&](const Catalogue& given) { return catalogue_json(given, task_of(report)); })},
      {"trade_off",
       or_null(report.trade_off,
               [&](const auto& front) { return trade_off_json(front, report.physical); })},
      {"physical", physical_json(report)}};
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
  return {{"schema", "stillpoint/region-report/1"},
          {"program", program_json()},
          {"input", task},
          {"region", region_fields(answer)},
          {"strips", strips_json(answer.strips)},
          {"delta1_published", number(answer.delta1_published)},
          {"delta1_exact", number(answer.delta1_exact)},
          {"admissible", or_null(answer.admissible)},
          {"tolerance", number(answer.tolerance)},
          {"arrival", or_null(answer.arrival)},
          {"constraints", constraints_json(answer.constraints)},
          {"works_for", or_null(answer.works_for, works_for_json)},
          {"hits", hit_by ? hits_json(shown_hits(problem, *f, *delta)) : ordered_json(nullptr)},
          {"practice", or_null(answer.practice, practice_json)},
          {"catalogue",
           or_null(report.catalogue,
                   [&](const Catalogue& given) { return catalogue_json(given, task_of(report)); })},
          {"physical", physical_json(report)}};
}

}  // namespace stillpoint::report
