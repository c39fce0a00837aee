// SPDX-License-Identifier: MIT
#include "json_report.hpp"

#include "physical_report.hpp"
#include "version.hpp"

#include <cassert>
#include <cmath>
#include <variant>

namespace stillpoint::cli {

namespace {

using nlohmann::ordered_json;

ordered_json number(double value) {
  assert(std::isfinite(value));
  return value;
}

ordered_json number(const std::optional<double>& value) {
  return value ? number(*value) : ordered_json(nullptr);
}

/// A count: an integer as long as a double holds it exactly.
ordered_json count(const std::optional<double>& value) {
  constexpr double exact = 9007199254740992;  // 2^53
  if (value && *value <= exact) {
    return static_cast<std::int64_t>(*value);
  }
  return number(value);
}

ordered_json text(const std::string& value) {
  return value.empty() ? ordered_json(nullptr) : ordered_json(value);
}

ordered_json mends_json(const std::vector<design::Mend>& mends) {
  ordered_json list = ordered_json::array();
  for (const design::Mend& mend : mends) {
    list.push_back({{"input", mend.field}, {"value", number(mend.value)}});
  }
  return list;
}

/// The constraints and limits that exclude each other, by name; null where none do.
ordered_json conflict_json(design::Conflict conflict) {
  switch (conflict) {
    case design::Conflict::none:
      break;
    case design::Conflict::amplitude_against_return:
      return {"amplitude", "return"};
    case design::Conflict::amplitude_against_f_max:
      return {"amplitude", "f_max"};
    case design::Conflict::stop_against_start:
      return {"stop", "start"};
    case design::Conflict::stop_against_delta_max:
      return {"stop", "delta_max"};
    case design::Conflict::narrower_than_rounding:
      return {"rounding"};
  }
  return nullptr;
}

ordered_json region_fields(const design::Region& region, const std::string& reason,
                           const std::vector<design::Mend>& mends) {
  return {{"feasible", region.feasible},
          {"reason", text(reason)},
          {"conflict", conflict_json(region.conflict)},
          {"f1", number(region.f1)},
          {"f2", number(region.f2)},
          {"f3", number(region.f3)},
          {"f_lower", number(region.f_lower)},
          {"f_upper", number(region.f_upper)},
          {"delta2", number(region.delta2)},
          {"beta_min", number(region.beta_min)},
          {"mends", mends_json(mends)}};
}

template <class List>
ordered_json constraints_json(const List& constraints) {
  ordered_json list = ordered_json::array();
  for (const design::Constraint& constraint : constraints) {
    list.push_back({{"name", constraint.name},
                    {"relation", constraint.relation},
                    {"value", number(constraint.value)},
                    {"limit", number(constraint.limit)},
                    {"slack", number(constraint.slack)},
                    {"satisfied", constraint.satisfied}});
  }
  return list;
}

ordered_json response_json(const Response& response) {
  return {{"peak_amplitude", number(response.peak_amplitude)},
          {"peak_acceleration", number(response.peak_acceleration)},
          {"half_cycles", count(response.half_cycles)},
          {"turning_points", count(response.turning_points)},
          {"zero_passages", count(response.zero_passages)},
          {"stop_time", number(response.stop_time)},
          {"stop_position", number(response.stop_position)},
          {"stops_at_zero", response.stops_at_zero},
          {"outcome", name(response.outcome)},
          {"arrival_speed", number(response.arrival_speed)},
          {"decision_margin", number(response.decision_margin)}};
}

ordered_json forced_json(const ForcedResponse& forced) {
  ordered_json json = response_json(forced);
  json["end_time"] = number(forced.end_time);
  json["final_position"] = number(forced.final_position);
  json["final_velocity"] = number(forced.final_velocity);
  json["sticks"] = count(forced.sticks);
  json["stick_time"] = number(forced.stick_time);
  json["left_notch_from_rest"] = forced.left_notch_from_rest;
  return json;
}

/// Its numbers as given; what a type does not have is null.
ordered_json excitation_json(const std::optional<ExcitationInput>& input) {
  if (!input) {
    return nullptr;
  }
  ordered_json json{{"type", input->type},
                    {"k", nullptr},
                    {"lambda", nullptr},
                    {"phase", nullptr},
                    {"duration", nullptr},
                    {"record", text(input->record.value_or(""))},
                    {"samples", nullptr},
                    {"record_units", text(input->record_units.value_or(""))},
                    {"record_step", number(input->record_step)},
                    {"record_scale", number(input->record_scale)}};
  const double lasts = duration(input->excitation);
  json["duration"] = std::isfinite(lasts) ? number(lasts) : ordered_json(nullptr);
  if (const auto* harmonic = std::get_if<Harmonic<>>(&input->excitation)) {
    json["phase"] = number(harmonic->phase);
  }
  std::visit(
      [&json](const auto& kind) {
        if constexpr (requires { kind.lambda; }) {
          json["k"] = number(kind.k);
          json["lambda"] = number(kind.lambda);
        } else if constexpr (requires { kind.values; }) {
          json["samples"] = kind.values.size();
        }
      },
      input->excitation);
  return json;
}

void add_pulse(ordered_json& task, const std::optional<design::Pulse>& pulse) {
  task["pulse"] = pulse ? ordered_json(design::name(*pulse)) : ordered_json(nullptr);
  task["k"] = pulse ? number(design::peak_load(*pulse)) : ordered_json(nullptr);
  task["lambda"] = pulse ? number(design::angular_frequency(*pulse)) : ordered_json(nullptr);
}

ordered_json design_point_json(const design::Problem& problem, const design::DesignPoint& point) {
  return {{"f", number(point.f)},
          {"delta", number(point.delta)},
          {"tolerance", number(point.tolerance)},
          {"delta1_published", number(design::delta1_published(problem, point.f))},
          {"delta1_exact", number(design::delta1_exact(problem, point.f))}};
}

ordered_json search_json(const design::SearchRecord& search) {
  return {{"library", "NLopt"},
          {"library_version", design::nlopt_version()},
          {"algorithm", search.algorithm},
          {"status", search.status},
          {"evaluations", search.evaluations},
          {"wall_time_s", number(search.wall_time_s)}};
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
  return {{"shortness", number(check.shortness)},
          {"friction_ratio", number(check.friction_ratio)},
          {"equivalent_v0", number(check.start.speed)},
          {"equivalent_start", number(check.start.tau)},
          {"peak_error", number(check.peak_error)},
          {"stop_time_error", number(check.stop_time_error)},
          {"warnings", warnings},
          {"response", forced_json(check.response)}};
}

ordered_json physical_json(const std::vector<Quantity>& quantities) {
  if (quantities.empty()) {
    return nullptr;
  }
  ordered_json object = ordered_json::object();
  for (const Quantity& quantity : quantities) {
    object[std::string(quantity.field)] = number(quantity.value);
  }
  return object;
}

ordered_json half_cycles_json(const std::vector<HalfCycle>& half_cycles) {
  ordered_json list = ordered_json::array();
  for (const HalfCycle& now : half_cycles) {
    list.push_back({{"index", now.index},
                    {"side", now.side},
                    {"start_time", number(now.start_time)},
                    {"departure_speed", number(now.departure_speed)},
                    {"peak_time", number(now.peak_time)},
                    {"peak", number(now.peak)},
                    {"end_time", number(now.end_time)},
                    {"end_position", number(now.end_position)},
                    {"arrival_speed", number(now.arrival_speed)}});
  }
  return list;
}

/// The part of `input` that design and region share.
ordered_json task_json(const design::Problem& problem, const design::Limits& limits) {
  return {{"v0", number(problem.v0)},
          {"p", number(problem.p)},
          {"beta", number(problem.beta)},
          {"criterion", name(problem.criterion)},
          {"tolerance", number(limits.tolerance)},
          {"f_max", number(limits.f_max)},
          {"delta_max", number(limits.delta_max)}};
}

}  // namespace

ordered_json program_json() {
  return {{"name", "stillpoint"}, {"version", program_version()}};
}

ordered_json design_json(const DesignInput& input, const design::DesignResult& result) {
  const auto& [problem, limits, search] = result.request;
  ordered_json task = task_json(problem, limits);
  add_pulse(task, input.pulse);
  task["objective"] = name(search.objective);
  task["algorithm"] = input.algorithm ? ordered_json(*input.algorithm) : ordered_json(nullptr);
  ordered_json report{{"schema", "stillpoint/design-report/1"},
                      {"program", program_json()},
                      {"input", task},
                      {"region", region_fields(result.region, result.reason, result.mends)},
                      {"design", nullptr},
                      {"constraints", ordered_json::array()},
                      {"response", nullptr},
                      {"search", nullptr},
                      {"cross_check", nullptr},
                      {"pulse", nullptr},
                      {"physical", physical_json(design_quantities(input, result))}};
  if (result.finding) {
    const design::Finding& finding = *result.finding;
    report["design"] = design_point_json(problem, finding.point);
    report["constraints"] = constraints_json(finding.constraints);
    report["response"] = response_json(finding.response);
    report["search"] = search_json(finding.search);
    report["cross_check"] = cross_check_json(finding.cross_check);
    if (finding.pulse) {
      report["pulse"] = pulse_check_json(*finding.pulse);
    }
  }
  return report;
}

ordered_json region_json(const RegionInput& input, const RegionAnswer& answer) {
  ordered_json task = task_json(input.problem, input.limits);
  task["f"] = number(input.f);
  task["delta"] = number(input.delta);
  return {
      {"schema", "stillpoint/region-report/1"},
      {"program", program_json()},
      {"input", task},
      {"region", region_fields(answer.region, answer.reason, answer.mends)},
      {"delta1_published", number(answer.delta1_published)},
      {"delta1_exact", number(answer.delta1_exact)},
      {"admissible", answer.admissible ? ordered_json(*answer.admissible) : ordered_json(nullptr)},
      {"tolerance", number(answer.tolerance)},
      {"constraints", constraints_json(answer.constraints)},
      {"physical", physical_json(region_quantities(input, answer))}};
}

ordered_json simulate_input_json(const SimulateInput& input) {
  return {{"v0", number(input.start.v0)},
          {"p", number(input.oscillator.p)},
          {"f", number(input.oscillator.f)},
          {"delta", number(input.oscillator.delta)},
          {"x0", number(input.start.x0)},
          {"t_end", number(input.t_end)},
          {"excitation", excitation_json(input.excitation)}};
}

ordered_json simulate_json(const SimulateInput& input, const SimulateAnswer& answer) {
  return {
      {"schema", "stillpoint/simulation-report/1"},
      {"program", program_json()},
      {"input", simulate_input_json(input)},
      {"response", answer.forced ? forced_json(*answer.forced) : response_json(answer.response)},
      {"half_cycles", half_cycles_json(answer.half_cycles)},
      {"half_cycles_listed", answer.half_cycles.size()},
      {"physical", physical_json(simulate_quantities(input, answer))}};
}

}  // namespace stillpoint::cli
