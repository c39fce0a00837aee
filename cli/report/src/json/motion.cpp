// SPDX-License-Identifier: MIT
#include <stillpoint/records/record_scaling.hpp>
#include <stillpoint/report/report.hpp>
#include "json/parts.hpp"

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
                    {"duration", number(duration(excitation))},
                    {"record", or_null(record, [](const RecordOrigin& from) { return from.file; })},
                    {"samples", nullptr},
                    {"record_units", or_null(origin.units)},
                    {"record_step", number(origin.step)},
                    {"record_scale", number(origin.scale)},
                    {"record_peak", number(origin.peak)},
                    {"record_spectrum", number(origin.spectrum)},
                    {"record_spectrum_period", number(origin.spectrum_period)},
                    {"record_units_read",
                     or_null(record, [](const RecordOrigin& from) { return from.units_read; })},
                    {"record_factor", nullptr},
                    {"pga", nullptr}};
  std::visit(
      [&]<class Kind>(const Kind& kind) {
        if constexpr (requires { kind.lambda; }) {
          json["k"] = number(kind.k);
          json["lambda"] = number(kind.lambda);
        } else if constexpr (requires { kind.values; }) {
          json["samples"] = kind.values.size();
          json["record_factor"] = number(origin.factor);
          json["pga"] = number(records::peak_acceleration(kind));
        }
        if constexpr (IsSine<Kind> && !IsPulse<Kind>) {
          json["phase"] = number(kind.phase);
        }
      },
      excitation);
  return json;
}

ordered_json half_cycles_json(const std::vector<HalfCycle>& half_cycles) {
  return list_json(half_cycles, [](const HalfCycle& now) -> ordered_json {
    return {{"index", now.index},
            {"side", now.side},
            {"start_time", number(now.start_time)},
            {"departure_speed", number(now.departure_speed)},
            {"peak_time", number(now.peak_time)},
            {"peak", number(now.peak)},
            {"end_time", number(now.end_time)},
            {"end_position", number(now.end_position)},
            {"arrival_speed", number(now.arrival_speed)},
            {"impulse", number(now.impulse)}};
  });
}

ordered_json zones_json(const std::vector<FrictionZone>& zones) {
  ordered_json list = list_json(zones, [](const FrictionZone& zone) -> ordered_json {
    return {{"to", number(zone.to)}, {"f", number(zone.f)}};
  });
  return list.empty() ? ordered_json() : list;
}

}  // namespace

ordered_json motion_input_json(const SimulationRequest& request,
                               const std::optional<RecordOrigin>& record) {
  return {{"v0", number(request.start.v0)},
          {"p", number(request.oscillator.p)},
          {"f", number(request.oscillator.f)},
          {"delta", number(request.oscillator.delta)},
          {"x0", number(request.start.x0)},
          {"t_end", number(request.t_end)},
          {"excitation", excitation_json(request.excitation, record)},
          {"hold", number(request.oscillator.hold)},
          {"notch_width", number(request.surface.notch_width)},
          {"friction_zones", zones_json(request.surface.zones)}};
}

ordered_json json(const MotionReport& report) {
  const Simulation& answer = report.answer;
  return {
      {"schema", "stillpoint/simulation-report/1"},
      {"program", program_json()},
      {"input", motion_input_json(report.request, report.record)},
      {"response", answer.forced ? forced_json(*answer.forced) : response_json(answer.response)},
      {"caught_impulse", number(caught_impulse(report))},
      {"half_cycles", half_cycles_json(answer.half_cycles)},
      {"half_cycles_listed", answer.half_cycles.size()},
      {"physical", physical_json(report)}};
}

}  // namespace stillpoint::report
