// SPDX-License-Identifier: MIT
#include "json/head_fields.hpp"
#include "json/physical_fields.hpp"

#include "sections.hpp"

#include <stillpoint/records/record_scaling.hpp>

namespace stillpoint::report {

using nlohmann::ordered_json;

std::optional<ShownExcitation> shown(const Excitation& excitation,
                                     const std::optional<RecordOrigin>& record) {
  if (std::holds_alternative<NoExcitation>(excitation)) {
    return std::nullopt;
  }
  ShownExcitation now{.type = name(excitation), .duration = duration(excitation)};
  std::visit(
      [&]<class Kind>(const Kind& kind) {
        if constexpr (requires { kind.lambda; }) {
          now.k = kind.k;
          now.lambda = kind.lambda;
        } else if constexpr (requires { kind.values; }) {
          now.samples = kind.values.size();
          now.pga = records::peak_acceleration(kind);
        }
        if constexpr (IsSine<Kind> && !IsPulse<Kind>) {
          now.phase = kind.phase;
        }
      },
      excitation);
  now.record = record;
  return now;
}

namespace {

constexpr auto schema_name = std::to_array<std::string_view>({"stillpoint/simulation-report/1"});

struct MotionSi : Si {
  std::optional<double> caught_impulse{};

  static constexpr auto field_table =
      std::tuple_cat(scale_fields, damper_fields, motion_fields_si, practice_fields_si,
                     std::tuple{Field{"caught_impulse_n_s", &MotionSi::caught_impulse, "",
                                      si_always(Dimension::impulse)}},
                     wave_fields);
};

ShownResponse response_of(const MotionReport& report) {
  const Simulation& answer = report.answer;
  return answer.forced ? ShownResponse(*answer.forced, answer.energies)
                       : ShownResponse(answer.response, answer.energies);
}

std::optional<double> caught(const MotionReport& report) {
  return design::caught_impulse(report.request, report.answer.response);
}

std::optional<MotionSi> physical_of(const MotionReport& report) {
  if (!report.physical) {
    return std::nullopt;
  }
  const auto load = shown(report.request.excitation, {});
  const bool wave = load && load->lambda;
  return MotionSi{{.input = *report.physical,
                   .velocity_m_per_s = report.physical->velocity_m_per_s,
                   .f = report.request.oscillator.f,
                   .delta = report.request.oscillator.delta,
                   .practice = design::practice(report.request, report.answer),
                   .lambda = wave ? load->lambda : std::nullopt,
                   .duration = wave ? load->duration : std::nullopt,
                   .motion = response_of(report)},
                  caught(report)};
}

constexpr auto motion_table = std::tuple_cat(
    head_fields<MotionReport, schema_name>, told_fields<MotionReport>,
    std::tuple{
        Field{"input", motion_input}, Field{"response", &response_of},
        Field{"caught_impulse", &caught,
              "per mass, for a hit that the notch catches at the start; null if it does not"},
        Field{"practice",
              [](const MotionReport& report) {
                return design::practice(report.request, report.answer);
              },
              "docs/theory.md section 11; null except after a hit from x = 0 without a load and "
              "with "
              "the paper's notch; notch_width_min is null"},
        Field{"half_cycles", in(&MotionReport::answer, &Simulation::half_cycles),
              "the first of them, at most --max-half-cycles"},
        Field{"half_cycles_listed",
              [](const MotionReport& report) { return report.answer.half_cycles.size(); }},
        Field{"physical", &physical_of,
              "in the units at the ends of the names; null with dimensionless input; under an "
              "excitation with its end as well"}});

}  // namespace

nlohmann::ordered_json json(const MotionReport& report) {
  return object_by<motion_table>(report, scales_of(report.physical));
}

nlohmann::ordered_json simulation_schema() {
  return report_schema<MotionReport>(motion_table, schema_name.front(), "simulate --json");
}

}  // namespace stillpoint::report
