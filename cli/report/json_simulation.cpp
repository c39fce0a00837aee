// SPDX-License-Identifier: MIT
#include "json_parts.hpp"
#include "json_report.hpp"
#include "physical_report.hpp"

#include <cmath>
#include <variant>

namespace stillpoint::cli {

using nlohmann::ordered_json;

namespace {

/// Its numbers as given; what a type does not have is null.
ordered_json excitation_json(const SimulateInput& input) {
  if (!is_forced(input.request)) {
    return nullptr;
  }
  const Excitation& excitation = input.request.excitation;
  const report::RecordOrigin origin = input.record.value_or(report::RecordOrigin());
  ordered_json json{{"type", name(excitation)},
                    {"k", nullptr},
                    {"lambda", nullptr},
                    {"phase", nullptr},
                    {"duration", nullptr},
                    {"record", text(origin.file)},
                    {"samples", nullptr},
                    {"record_units", text(origin.units.value_or(""))},
                    {"record_step", number(origin.step)},
                    {"record_scale", number(origin.scale)}};
  json["duration"] = number(duration(excitation));
  if (const auto* harmonic = std::get_if<Harmonic>(&excitation)) {
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
      excitation);
  return json;
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

}  // namespace

ordered_json simulate_input_json(const SimulateInput& input) {
  return {
      {"v0", number(input.request.start.v0)},    {"p", number(input.request.oscillator.p)},
      {"f", number(input.request.oscillator.f)}, {"delta", number(input.request.oscillator.delta)},
      {"x0", number(input.request.start.x0)},    {"t_end", number(input.request.t_end)},
      {"excitation", excitation_json(input)}};
}

ordered_json simulate_json(const SimulateInput& input, const Simulation& answer) {
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
