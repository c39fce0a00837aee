// SPDX-License-Identifier: MIT
#include "json/parts.hpp"

#include <cmath>
#include <numbers>
#include <variant>

namespace stillpoint::report {

namespace {

using nlohmann::ordered_json;

/// Without values beyond a double.
std::optional<double> finite(const std::optional<double>& value) {
  return value && std::isfinite(*value) ? value : std::nullopt;
}

std::optional<double> times(const std::optional<double>& value, double unit) {
  return value ? std::optional(*value * unit) : std::nullopt;
}

ordered_json scale_values(const design::PhysicalInput& physical, double velocity_m_per_s) {
  const design::Scales& scales = physical.scales;
  return {{"length_unit_m", number(scales.length_m)},
          {"time_unit_s", number(scales.time_s)},
          {"velocity_unit_m_per_s", number(scales.velocity_m_per_s)},
          {"gravity_m_per_s2", number(scales.gravity_m_per_s2)},
          {"omega_rad_per_s", number(scales.omega_rad_per_s)},
          {"period_s", number(physical.period_s)},
          {"natural_frequency_hz", number(scales.omega_rad_per_s / (2 * std::numbers::pi))},
          {"mass_kg", number(scales.mass_kg)},
          {"stiffness_n_per_m", number(scales.stiffness_n_per_m())},
          {"velocity_m_per_s", number(velocity_m_per_s)}};
}

void add_region(ordered_json& json, const design::PhysicalInput& physical,
                const design::Region& region) {
  json["max_displacement_m"] = number(physical.max_displacement_m);
  json["max_displacement_min_m"] = number(region.beta_min * physical.scales.length_m);
  json["delta2_m"] = number(finite(times(region.delta2, physical.scales.length_m)));
}

/// Null if that input alone cannot make it feasible.
void add_mends(ordered_json& json, design::PhysicalInput physical,
               const std::vector<design::Mend>& mends) {
  const auto mended = [&](std::string_view field, bool by_stiffness) -> std::optional<double> {
    physical.by_stiffness = by_stiffness;
    physical.by_frequency = false;
    for (const design::Mend& mend : mends) {
      if (mend.field == field) {
        return physical_mend(physical, mend)->value;
      }
    }
    return std::nullopt;
  };
  json["velocity_mend_m_per_s"] = number(mended("v0", false));
  json["period_mend_s"] = number(mended("p", false));
  json["stiffness_mend_n_per_m"] =
      number(physical.scales.mass_kg ? finite(mended("p", true)) : std::nullopt);
  json["max_displacement_mend_m"] = number(mended("beta", false));
  json["delta_max_mend_m"] = number(mended("delta_max", false));
}

void add_damper(ordered_json& json, const design::Scales& scales, const std::optional<double>& f,
                const std::optional<double>& delta) {
  json["f"] = number(f);
  json["delta_m"] = number(times(delta, scales.length_m));
  json["friction_force_n"] = number(f ? finite(scales.friction_force_n(*f)) : std::nullopt);
  json["energy_per_passage_j"] =
      number(delta ? finite(scales.energy_per_passage_j(*delta)) : std::nullopt);
}

/// Null without a mass or the value.
std::optional<double> times(const std::optional<double>& value, const std::optional<double>& unit) {
  return unit ? finite(times(value, *unit)) : std::nullopt;
}

void add_served(ordered_json& json, const design::Scales& scales,
                const std::optional<design::WorksFor>& served) {
  json["works_for_velocity_m_per_s"] = nullptr;
  json["works_for_period_s"] = nullptr;
  if (served) {
    const auto [velocity, period] = physical_works_for(scales, *served);
    json["works_for_velocity_m_per_s"] = {number(velocity.low), number(velocity.high)};
    json["works_for_period_s"] = {number(period.low), number(period.high)};
  }
}

void add_hits(ordered_json& json, const design::Scales& scales,
              const std::vector<design::Hits>& hits) {
  json["hits"] = list_json(hits, [&](const design::Hits& now) -> ordered_json {
    return {{"from_m_per_s", number(now.from * scales.velocity_m_per_s)},
            {"to_m_per_s", number(now.to * scales.velocity_m_per_s)},
            {"rest_m", number(times(now.rest, scales.length_m))}};
  });
}

void add_practice(ordered_json& json, const design::Scales& scales,
                  const std::optional<design::Practice>& lines) {
  const design::Practice now = lines.value_or(design::Practice());
  const auto weight = scales.friction_force_n(1);
  const auto energy = scales.energy_per_passage_j(now.notch_capacity);
  const std::optional<double> momentum = scales.impulse_n_s(1);
  json["secant_stiffness_n_per_m"] =
      number(weight ? times(now.secant_stiffness, *weight / scales.length_m) : std::nullopt);
  json["impulse_at_stop_n_s"] = number(times(now.impulse_at_stop, momentum));
  json["impulse_largest_n_s"] = number(times(now.impulse_largest, momentum));
  json["energy_at_stop_j"] = number(times(now.notch_used, energy));
  json["notch_width_min_m"] = number(times(now.notch_width_min, scales.length_m));
}

void add_response(ordered_json& json, const design::Scales& scales,
                  const std::optional<Response>& response) {
  const auto scaled = [&](double Response::*metric, double unit) {
    return number(response ? std::optional(*response.*metric * unit) : std::nullopt);
  };
  const Response now = response.value_or(Response());
  json["peak_m"] = scaled(&Response::peak_amplitude, scales.length_m);
  json["peak_acceleration_m_per_s2"] =
      scaled(&Response::peak_acceleration, scales.gravity_m_per_s2);
  json["peak_absolute_acceleration_m_per_s2"] =
      scaled(&Response::peak_absolute_acceleration, scales.gravity_m_per_s2);
  json["stop_time_s"] = number(times(now.stop_time, scales.time_s));
  json["stop_position_m"] = number(times(now.stop_position, scales.length_m));
  json["arrival_speed_m_per_s"] = number(times(now.arrival_speed, scales.velocity_m_per_s));
}

/// Of a wave; null for a record and where there is none.
void add_excitation(ordered_json& json, const design::Scales& scales,
                    const Excitation& excitation) {
  std::optional<double> lambda;
  std::visit(
      [&lambda](const auto& kind) {
        if constexpr (requires { kind.lambda; }) {
          lambda = kind.lambda;
        }
      },
      excitation);
  json["excitation_rad_per_s"] = number(finite(times(lambda, 1 / scales.time_s)));
  json["excitation_frequency_hz"] =
      number(finite(times(lambda, 1 / (2 * std::numbers::pi * scales.time_s))));
  json["excitation_duration_s"] =
      number(lambda ? finite(times(duration(excitation), scales.time_s)) : std::nullopt);
}

}  // namespace

ordered_json physical_json(const DesignReport& report) {
  if (!report.physical) {
    return nullptr;
  }
  const design::DesignResult& result = report.result;
  const design::DesignRequest& request = result.request;
  const auto& finding = result.finding;
  const design::Scales& scales = report.physical->scales;
  const double v0 = request.pulse ? result.reduced_v0.value_or(0) : request.problem.v0;
  ordered_json json = scale_values(*report.physical, v0 * scales.velocity_m_per_s);
  add_region(json, *report.physical, result.region);
  add_mends(json, *report.physical, result.mends);
  if (finding) {
    add_damper(json, scales, finding->point.f, finding->point.delta);
  } else {
    add_damper(json, scales, {}, {});
  }
  add_served(json, scales, finding ? finding->works_for : std::nullopt);
  json["hits"] = nullptr;
  if (finding && !request.pulse) {
    add_hits(json, scales, shown_hits(request.problem, finding->point.f, finding->point.delta));
  }
  add_practice(json, scales, finding ? finding->practice : std::nullopt);
  add_response(json, scales, finding ? std::optional(finding->response) : std::nullopt);
  if (request.pulse && !result.reduced_v0) {
    json["velocity_m_per_s"] = nullptr;  // of a full sine
  }
  add_excitation(json, scales, request.pulse ? design::excitation(*request.pulse) : NoExcitation{});
  return json;
}

ordered_json physical_json(const RegionReport& report) {
  if (!report.physical) {
    return nullptr;
  }
  const design::Scales& scales = report.physical->scales;
  const design::RegionAnswer& answer = report.answer;
  ordered_json json = scale_values(*report.physical, report.physical->velocity_m_per_s);
  add_region(json, *report.physical, answer.region);
  add_mends(json, *report.physical, answer.mends);
  add_damper(json, scales, report.request.f, report.request.delta);
  const auto& [problem, limits, f, delta, pulse, ranges] = report.request;
  add_served(json, scales, answer.works_for);
  json["hits"] = nullptr;
  if (f && delta && !pulse) {
    add_hits(json, scales, shown_hits(problem, *f, *delta));
  }
  if (pulse) {
    json["velocity_m_per_s"] = nullptr;
  }
  add_practice(json, scales, answer.practice);
  json["delta1_published_m"] = number(times(answer.delta1_published, scales.length_m));
  json["delta1_exact_m"] = number(times(answer.delta1_exact, scales.length_m));
  add_excitation(json, scales, pulse ? design::excitation(*pulse) : NoExcitation{});
  return json;
}

ordered_json physical_json(const MotionReport& report) {
  if (!report.physical) {
    return nullptr;
  }
  const design::Scales& scales = report.physical->scales;
  const auto& [p, f, delta, hold] = report.request.oscillator;
  ordered_json json = scale_values(*report.physical, report.physical->velocity_m_per_s);
  add_damper(json, scales, f, delta);
  add_response(json, scales, report.answer.response);
  const std::optional<double> caught = caught_impulse(report);
  json["caught_impulse_n_s"] = number(caught ? scales.impulse_n_s(*caught) : std::nullopt);
  add_excitation(json, scales, report.request.excitation);
  if (report.answer.forced) {
    const ForcedResponse& forced = *report.answer.forced;
    json["end_time_s"] = number(times(forced.end_time, scales.time_s));
    json["final_position_m"] = number(times(forced.final_position, scales.length_m));
    json["final_velocity_m_per_s"] = number(times(forced.final_velocity, scales.velocity_m_per_s));
    json["stick_time_s"] = number(forced.stick_time * scales.time_s);
    json["locked_from_s"] = number(times(forced.locked_from, scales.time_s));
    json["largest_load_while_locked_m_per_s2"] =
        number(times(forced.largest_load_while_locked, scales.gravity_m_per_s2));
  }
  return json;
}

}  // namespace stillpoint::report
