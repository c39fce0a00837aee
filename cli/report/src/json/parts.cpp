// SPDX-License-Identifier: MIT
#include "json/parts.hpp"

#include <stillpoint/report/version.hpp>

#include <algorithm>
#include <cassert>
#include <cmath>

namespace stillpoint::report {

using nlohmann::ordered_json;

std::string json_text(const ordered_json& json) {
  constexpr int spaces = 2;
  return json.dump(spaces) + "\n";
}

namespace {

ordered_json mends_json(const std::vector<design::Mend>& mends) {
  return list_json(mends, [](const design::Mend& mend) -> ordered_json {
    return {{"input", mend.field}, {"value", number(mend.value)}};
  });
}

ordered_json joint_json(const design::JointMend& joint) {
  return {{"largest_tolerance", number(joint.largest_tolerance)},
          {"mends", mends_json(joint.mends)}};
}

ordered_json point_json(const design::DesignPoint& point) {
  return {{"tolerance", number(point.tolerance)},
          {"f", number(point.f)},
          {"delta", number(point.delta)}};
}

ordered_json intervals_json(const std::vector<Interval>& intervals) {
  return list_json(intervals, [](const Interval& interval) -> ordered_json {
    return {number(interval.low), number(interval.high)};
  });
}

/// The constraints and limits that conflict, by name; null where none do.
ordered_json conflict_json(const design::Region& region) {
  switch (region.conflict) {
    case design::Conflict::none:
      break;
    case design::Conflict::amplitude_against_return:
      return {"amplitude", "return"};
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

ordered_json number(double value) {
  assert(std::isfinite(value));
  return value;
}

ordered_json number(const std::optional<double>& value) {
  return or_null(value, [](double plain) { return number(plain); });
}

ordered_json count(const std::optional<double>& value) {
  constexpr double exact = 9007199254740992;  // 2^53
  if (value && *value <= exact) {
    return static_cast<std::int64_t>(*value);
  }
  return number(value);
}

ordered_json metres(const Physical& physical, const std::optional<double>& length) {
  return physical && length ? number(*length * physical->scales.length_m) : ordered_json(nullptr);
}

ordered_json seconds(const Physical& physical, const std::optional<double>& tau) {
  return physical && tau ? number(*tau * physical->scales.time_s) : ordered_json(nullptr);
}

ordered_json region_fields(const design::RegionVerdict& verdict) {
  const design::Region& region = verdict.region;
  return {{"feasible", region.feasible},
          {"reason", or_null(verdict.reason)},
          {"conflict", conflict_json(region)},
          {"f1", number(region.f1)},
          {"f2", number(region.f2)},
          {"f3", number(region.f3)},
          {"f4", number(region.f4)},
          {"f_lower", number(region.f_lower)},
          {"f_upper", number(region.f_upper)},
          {"delta2", number(region.delta2)},
          {"beta_min", number(region.beta_min)},
          {"by", verdict.intervals ? ordered_json("forced_motion") : ordered_json(nullptr)},
          {"intervals", or_null(verdict.intervals, intervals_json)},
          {"most_tolerant", or_null(verdict.most_tolerant, point_json)},
          {"mends", mends_json(verdict.mends)},
          {"joint_mend", or_null(verdict.joint_mend, joint_json)},
          {"criterion_mend",
           or_null(verdict.criterion_mend, [](const auto& criterion) { return name(criterion); })}};
}

ordered_json constraints_json(std::span<const design::Constraint> constraints) {
  return list_json(constraints, [](const design::Constraint& constraint) -> ordered_json {
    return {{"name", constraint.name},           {"variable", constraint.variable},
            {"relation", constraint.relation},   {"value", number(constraint.value)},
            {"limit", number(constraint.limit)}, {"slack", number(constraint.slack)},
            {"satisfied", constraint.satisfied}};
  });
}

ordered_json response_json(const Response& response) {
  return {{"peak_amplitude", number(response.peak_amplitude)},
          {"peak_acceleration", number(response.peak_acceleration)},
          {"peak_absolute_acceleration", number(response.peak_absolute_acceleration)},
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
  json["locked_from"] = number(forced.locked_from);
  json["largest_load_while_locked"] = number(forced.largest_load_while_locked);
  return json;
}

ordered_json side_json(const design::BoxShape& shape, double tolerance, double below,
                       double above) {
  return shape == design::BoxShape{}
             ? ordered_json(nullptr)
             : ordered_json{number(1 - tolerance * below), number(1 + tolerance * above)};
}

ordered_json task_json(const design::Problem& problem, const design::Limits& limits) {
  const auto range = [](const std::optional<double>& low, const std::optional<double>& high) {
    return low && high ? ordered_json{number(*low), number(*high)} : ordered_json(nullptr);
  };
  const double t = limits.tolerance;
  const auto& [f_low, f_high, delta_low, delta_high] = limits.shape;
  ordered_json json{{"v0", number(problem.v0)},
                    {"v0_range", range(problem.v0_low, problem.v0)},
                    {"p", number(problem.p)},
                    {"p_range", range(problem.p, problem.p_high)},
                    {"beta", number(problem.beta)},
                    {"criterion", name(problem.criterion)},
                    {"arrivals", problem.arrivals},
                    {"residual", number(problem.residual)},
                    {"tolerance", number(t * std::min({f_low, f_high, delta_low, delta_high}))},
                    {"tolerance_f", side_json(limits.shape, t, f_low, f_high)},
                    {"tolerance_delta", side_json(limits.shape, t, delta_low, delta_high)}};
  for (const design::LimitKind& kind : design::limit_kinds()) {
    json[std::string(kind.field)] = number(limits.*kind.value);
  }
  return json;
}

ordered_json program_json() {
  return {{"name", "stillpoint"}, {"version", program_version()}};
}

}  // namespace stillpoint::report
