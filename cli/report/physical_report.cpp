// SPDX-License-Identifier: MIT
#include "physical_report.hpp"

#include <cmath>
#include <numbers>
#include <variant>

namespace stillpoint::cli {

namespace {

using Quantities = std::vector<PhysicalValue>;

/// Without what is beyond a double.
std::optional<double> finite(const std::optional<double>& value) {
  return value && std::isfinite(*value) ? value : std::nullopt;
}

std::optional<double> times(const std::optional<double>& value, double unit) {
  return value ? std::optional(*value * unit) : std::nullopt;
}

Quantities scale_quantities(const design::PhysicalInput& physical) {
  const design::Scales& scales = physical.scales;
  return {{"length_unit_m", scales.length_m},
          {"time_unit_s", scales.time_s},
          {"velocity_unit_m_per_s", scales.velocity_m_per_s},
          {"gravity_m_per_s2", scales.gravity_m_per_s2},
          {"omega_rad_per_s", scales.omega_rad_per_s},
          {"period_s", physical.period_s},
          {"mass_kg", scales.mass_kg},
          {"stiffness_n_per_m", scales.stiffness_n_per_m()},
          {"velocity_m_per_s", physical.velocity_m_per_s}};
}

void add_region(Quantities& list, const design::PhysicalInput& physical,
                const design::Region& region) {
  list.push_back({"max_displacement_m", physical.max_displacement_m});
  list.push_back({"max_displacement_min_m", region.beta_min * physical.scales.length_m});
  list.push_back({"delta2_m", physical.scales.delta_m(region.delta2)});
}

/// Mended inputs; null where that input alone cannot mend it.
void add_mends(Quantities& list, design::PhysicalInput physical,
               const std::vector<design::Mend>& mends) {
  const auto mended = [&](std::string_view field) -> std::optional<double> {
    for (const design::Mend& mend : mends) {
      if (mend.field == field) {
        return physical_mend(physical, mend)->value;
      }
    }
    return std::nullopt;
  };
  physical.by_stiffness = false;
  list.push_back({"velocity_mend_m_per_s", mended("v0")});
  list.push_back({"period_mend_s", mended("p")});
  physical.by_stiffness = true;
  list.push_back(
      {"stiffness_mend_n_per_m", physical.scales.mass_kg ? finite(mended("p")) : std::nullopt});
  list.push_back({"max_displacement_mend_m", mended("beta")});
  list.push_back({"delta_max_mend_m", mended("delta_max")});
}

void add_damper(Quantities& list, const design::Scales& scales, const std::optional<double>& f,
                const std::optional<double>& delta) {
  list.push_back({"f", f});
  list.push_back({"delta_m", times(delta, scales.length_m)});
  list.push_back({"friction_force_n", f ? finite(scales.friction_force_n(*f)) : std::nullopt});
  list.push_back(
      {"energy_per_passage_j", delta ? finite(scales.energy_per_passage_j(*delta)) : std::nullopt});
}

void add_response(Quantities& list, const design::Scales& scales,
                  const std::optional<Response>& response) {
  const Response none;
  const Response& now = response ? *response : none;
  const auto existing = [&](double value) {
    return response ? std::optional(value) : std::nullopt;
  };
  list.push_back({"peak_m", existing(now.peak_amplitude * scales.length_m)});
  list.push_back(
      {"peak_acceleration_m_per_s2", existing(now.peak_acceleration * scales.gravity_m_per_s2)});
  list.push_back({"stop_time_s", times(now.stop_time, scales.time_s)});
  list.push_back({"stop_position_m", times(now.stop_position, scales.length_m)});
  list.push_back({"arrival_speed_m_per_s", times(now.arrival_speed, scales.velocity_m_per_s)});
}

/// Of a wave; null for a record and where there is none.
void add_excitation(Quantities& list, const design::Scales& scales, const Excitation& excitation) {
  std::optional<double> lambda;
  std::visit(
      [&lambda](const auto& kind) {
        if constexpr (requires { kind.lambda; }) {
          lambda = kind.lambda;
        }
      },
      excitation);
  list.push_back({"excitation_rad_per_s", finite(times(lambda, 1 / scales.time_s))});
  list.push_back({"excitation_duration_s",
                  lambda ? finite(times(duration(excitation), scales.time_s)) : std::nullopt});
}

}  // namespace

Quantities design_quantities(const DesignInput& input, const design::DesignResult& result) {
  if (!input.physical) {
    return {};
  }
  design::PhysicalInput physical = *input.physical;
  const design::Scales& scales = physical.scales;
  physical.velocity_m_per_s = result.request.problem.v0 * scales.velocity_m_per_s;
  Quantities list = scale_quantities(physical);
  add_region(list, *input.physical, result.region);
  add_mends(list, *input.physical, result.mends);
  if (result.finding) {
    add_damper(list, scales, result.finding->point.f, result.finding->point.delta);
    add_response(list, scales, result.finding->response);
  } else {
    add_damper(list, scales, {}, {});
    add_response(list, scales, {});
  }
  add_excitation(list, scales,
                 result.request.pulse ? design::excitation(*result.request.pulse) : NoExcitation{});
  return list;
}

Quantities region_quantities(const RegionInput& input, const design::RegionAnswer& answer) {
  if (!input.physical) {
    return {};
  }
  const design::Scales& scales = input.physical->scales;
  Quantities list = scale_quantities(*input.physical);
  add_region(list, *input.physical, answer.region);
  add_mends(list, *input.physical, answer.mends);
  add_damper(list, scales, input.request.f, input.request.delta);
  list.push_back({"delta1_published_m", times(answer.delta1_published, scales.length_m)});
  list.push_back({"delta1_exact_m", times(answer.delta1_exact, scales.length_m)});
  return list;
}

Quantities simulate_quantities(const SimulateInput& input, const Simulation& answer) {
  if (!input.physical) {
    return {};
  }
  const design::Scales& scales = input.physical->scales;
  Quantities list = scale_quantities(*input.physical);
  add_damper(list, scales, input.request.oscillator.f, input.request.oscillator.delta);
  add_response(list, scales, answer.response);
  add_excitation(list, scales, input.request.excitation);
  if (answer.forced) {
    const ForcedResponse& forced = *answer.forced;
    list.push_back({"end_time_s", times(forced.end_time, scales.time_s)});
    list.push_back({"final_position_m", times(forced.final_position, scales.length_m)});
    list.push_back(
        {"final_velocity_m_per_s", times(forced.final_velocity, scales.velocity_m_per_s)});
    list.push_back({"stick_time_s", forced.stick_time * scales.time_s});
  }
  return list;
}

}  // namespace stillpoint::cli
