// SPDX-License-Identifier: MIT
#include <stillpoint/records/record_scaling.hpp>
#include <stillpoint/report/report.hpp>
#include "json/parts.hpp"
#include "sections.hpp"

#include <cmath>
#include <variant>

namespace stillpoint::report {

using nlohmann::ordered_json;

namespace {

/// Its numbers as given; null for what a type does not have.
ordered_json excitation_json(const Excitation& excitation,
                             const std::optional<RecordOrigin>& record) {
  if (std::holds_alternative<NoExcitation>(excitation)) {
    return nullptr;
  }
  const RecordOrigin origin = record.value_or(RecordOrigin());
  ordered_json json{{"type", name(excitation)},
                    {"k", nullptr},
                    {"lambda", nullptr},
                    {"phase", nullptr},
                    {"duration", duration(excitation)},
                    {"record", or_null(record, [](const RecordOrigin& from) { return from.file; })},
                    {"samples", nullptr},
                    {"record_units", origin.units},
                    {"record_step", origin.step},
                    {"record_scale", origin.scale},
                    {"record_peak", origin.peak},
                    {"record_spectrum", origin.spectrum},
                    {"record_spectrum_period", origin.spectrum_period},
                    {"record_units_read",
                     or_null(record, [](const RecordOrigin& from) { return from.units_read; })},
                    {"record_units_assumed",
                     or_null(record, [](const RecordOrigin& from) { return from.assumed; })},
                    {"record_factor", nullptr},
                    {"pga", nullptr}};
  std::visit(
      [&]<class Kind>(const Kind& kind) {
        if constexpr (requires { kind.lambda; }) {
          json["k"] = kind.k;
          json["lambda"] = kind.lambda;
        } else if constexpr (requires { kind.values; }) {
          json["samples"] = kind.values.size();
          json["record_factor"] = origin.factor;
          json["pga"] = records::peak_acceleration(kind);
        }
        if constexpr (IsSine<Kind> && !IsPulse<Kind>) {
          json["phase"] = kind.phase;
        }
      },
      excitation);
  return json;
}

ordered_json half_cycle_json(const HalfCycle& now) {
  return {{"index", now.index},
          {"side", now.side},
          {"start_time", now.start_time},
          {"departure_speed", now.departure_speed},
          {"peak_time", now.peak_time},
          {"peak", now.peak},
          {"end_time", now.end_time},
          {"end_position", now.end_position},
          {"arrival_speed", now.arrival_speed},
          {"impulse", now.impulse}};
}

ordered_json zones_json(const std::vector<FrictionZone>& zones) {
  const auto zone_json = [](const FrictionZone& zone) -> ordered_json {
    return {{"to", zone.to}, {"f", zone.f}};
  };
  return zones.empty() ? ordered_json() : list_json(zones, zone_json);
}

}  // namespace

ordered_json motion_input_json(const SimulationRequest& request,
                               const std::optional<RecordOrigin>& record) {
  return {{"v0", request.start.v0},
          {"p", request.oscillator.p},
          {"f", request.oscillator.f},
          {"delta", request.oscillator.delta},
          {"x0", request.start.x0},
          {"t_end", request.t_end},
          {"excitation", excitation_json(request.excitation, record)},
          {"hold", request.oscillator.hold},
          {"notch_width", request.surface.notch_width},
          {"friction_zones", zones_json(request.surface.zones)}};
}

ordered_json json(const MotionReport& report) {
  const Simulation& answer = report.answer;
  return {
      {"schema", "stillpoint/simulation-report/1"},
      {"program", program_json()},
      {"input", motion_input_json(report.request, report.record)},
      {"response", answer.forced ? forced_json(*answer.forced) : response_json(answer.response)},
      {"caught_impulse", caught_impulse(report)},
      {"practice", practice_json(practice_of(report),
                                 design::impulses(report.request.oscillator, answer.response))},
      {"half_cycles", list_json(answer.half_cycles, half_cycle_json)},
      {"half_cycles_listed", answer.half_cycles.size()},
      {"physical", physical_json(report)}};
}

}  // namespace stillpoint::report
