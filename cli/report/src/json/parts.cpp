// SPDX-License-Identifier: MIT
#include "json/parts.hpp"
#include "json/motion_fields.hpp"

#include <stillpoint/core/response_fields.hpp>
#include <stillpoint/records/text.hpp>
#include <stillpoint/report/version.hpp>

#include <fmt/format.h>

#include <algorithm>
#include <cassert>
#include <cmath>

namespace stillpoint::report {

using nlohmann::ordered_json;

namespace {

/// Any other number would be written as null.
[[maybe_unused]] bool is_finite(const ordered_json& json) {
  return json.is_structured() ? std::ranges::all_of(json, is_finite)
                              : !json.is_number_float() || std::isfinite(json.get<double>());
}

ordered_json mend_json(const design::Mend& mend) {
  return {{"input", mend.field}, {"value", mend.value}};
}

ordered_json point_json(const design::DesignPoint& point) {
  return {{"tolerance", point.tolerance}, {"f", point.f}, {"delta", point.delta}};
}

ordered_json intervals_json(const std::vector<Interval>& intervals) {
  return list_json(intervals, interval_json<Interval>);
}

/// The constraints and limits that conflict, by name; null where none do.
ordered_json conflict_json(const design::Region& region) {
  switch (region.conflict) {
    case design::Conflict::none:
      break;
    case design::Conflict::amplitude_against_return:
      return {"amplitude", "return"};
    case design::Conflict::amplitude_against_dead_zone:
      return {"amplitude", "dead_zone"};
    case design::Conflict::amplitude_against_limit:
      return {"amplitude", region.limit->constraint};
    case design::Conflict::limit_alone:
      return {region.limit->constraint};
    case design::Conflict::stop_against_start:
      return {"stop", "start"};
    case design::Conflict::stop_against_limit:
      return {"stop", region.limit->constraint};
    case design::Conflict::no_arrival:
      return {"stop", "arrivals"};
    case design::Conflict::narrower_than_rounding:
      return {"rounding"};
  }
  return nullptr;
}

}  // namespace

std::string json_text(const ordered_json& json) {
  constexpr int spaces = 2;
  assert(is_finite(json));
  // A terminal may show it: controls beyond ASCII are escaped too.
  const auto escaped = [](unsigned code) {
    return code == '\n' ? "\n" : fmt::format("\\u{:04x}", code);
  };
  return records::with_controls_as(escaped, json.dump(spaces)) + "\n";
}

ordered_json count(const std::optional<double>& value) {
  constexpr double exact = 9007199254740992;  // 2^53
  if (value && *value <= exact) {
    return static_cast<std::int64_t>(*value);
  }
  return value;
}

ordered_json metres(const Physical& physical, const std::optional<double>& length) {
  return physical && length ? ordered_json(*length * physical->scales.length_m) : nullptr;
}

ordered_json seconds(const Physical& physical, const std::optional<double>& tau) {
  return physical && tau ? ordered_json(*tau * physical->scales.time_s) : nullptr;
}

ordered_json region_fields(const design::RegionVerdict& verdict) {
  const design::Region& region = verdict.region;
  return {{"feasible", region.feasible},
          {"reason", verdict.reason},
          {"conflict", conflict_json(region)},
          {"f1", region.f1},
          {"f2", region.f2},
          {"f3", region.f3},
          {"f4", region.f4},
          {"f_lower", region.f_lower},
          {"f_upper", region.f_upper},
          {"delta2", region.delta2},
          {"beta_min", region.beta_min},
          {"by", verdict.intervals ? ordered_json("forced_motion") : ordered_json(nullptr)},
          {"intervals", or_null(verdict.intervals, intervals_json)},
          {"most_tolerant", or_null(verdict.most_tolerant, point_json)},
          {"mends", list_json(verdict.mends, mend_json)},
          {"mends_cut_short", verdict.mends_cut_short},
          {"largest_tolerance", verdict.largest_tolerance},
          {"criterion_mend",
           or_null(verdict.criterion_mend, [](const auto& criterion) { return name(criterion); })}};
}

ordered_json constraint_json(const design::Constraint& constraint) {
  return {{"name", constraint.name},          {"variable", constraint.variable},
          {"relation", constraint.relation},  {"value", constraint.value},
          {"limit", constraint.limit},        {"slack", constraint.slack},
          {"satisfied", constraint.satisfied}};
}

ordered_json response_json(const Response& response) {
  return object_json(response);
}

ordered_json response_json(const ForcedResponse& response) {
  return object_json(response);
}

ordered_json side_json(const design::BoxShape& shape, double tolerance, double below,
                       double above) {
  return shape == design::BoxShape{} ? ordered_json(nullptr)
                                     : ordered_json{1 - tolerance * below, 1 + tolerance * above};
}

ordered_json task_json(const design::Problem& problem, const design::Limits& limits) {
  const auto range = [](const std::optional<double>& low, const std::optional<double>& high) {
    return low && high ? ordered_json{*low, *high} : ordered_json(nullptr);
  };
  const double t = limits.tolerance;
  const auto& [f_low, f_high, delta_low, delta_high] = limits.shape;
  ordered_json json{{"v0", problem.v0},
                    {"v0_range", range(problem.v0_low, problem.v0)},
                    {"p", problem.p},
                    {"p_range", range(problem.p, problem.p_high)},
                    {"beta", problem.beta},
                    {"criterion", name(problem.criterion)},
                    {"arrivals", problem.arrivals},
                    {"residual", problem.residual},
                    {"tolerance", t * std::min({f_low, f_high, delta_low, delta_high})},
                    {"tolerance_f", side_json(limits.shape, t, f_low, f_high)},
                    {"tolerance_delta", side_json(limits.shape, t, delta_low, delta_high)}};
  for (const design::LimitKind& kind : design::limit_kinds()) {
    json[std::string(kind.field)] = limits.*kind.value;
  }
  return json;
}

ordered_json program_json() {
  return object_json(Program());
}

ordered_json own_json(const Version& version) {
  return version.text;
}

ordered_json own_schema(const Version* /*version*/) {
  return {{"type", "string"}, {"pattern", "^[0-9]+\\.[0-9]+\\.[0-9]+$"}};
}

}  // namespace stillpoint::report
