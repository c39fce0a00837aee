// SPDX-License-Identifier: MIT
#include "json/head_fields.hpp"
#include "json/motion_fields.hpp"
#include "json/schema.hpp"

#include <stillpoint/report/schemas.hpp>
#include "sections.hpp"

#include <stillpoint/records/record_scaling.hpp>
#include <stillpoint/report/report.hpp>

#include <tuple>

namespace stillpoint::report {

using nlohmann::ordered_json;

namespace {

constexpr auto schema_name = std::to_array<std::string_view>({"stillpoint/simulation-report/1"});

}  // namespace

ordered_json own_json(const Version& version) {
  return version.text;
}

ordered_json own_schema(const Version* /*version*/) {
  return {{"type", "string"}, {"pattern", "^[0-9]+\\.[0-9]+\\.[0-9]+$"}};
}

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

constexpr auto motion_table = std::tuple_cat(
    head_fields<MotionReport, schema_name>, told_fields<MotionReport>,
    std::tuple{
        Field{"input",
              [](const MotionReport& report) {
                return ShownMotion{{report.request}, report.record};
              }},
        Field{"response",
              [](const MotionReport& report) {
                return report.answer.forced ? ShownResponse(*report.answer.forced)
                                            : ShownResponse(report.answer.response);
              }},
        Field{"caught_impulse",
              [](const MotionReport& report) {
                return design::caught_impulse(report.request, report.answer.response);
              },
              "per mass, for a hit that the notch catches at the start; null if it does not"},
        Field{"practice", &practice_of,
              "docs/theory.md section 11; null except after a hit from x = 0 without a load and "
              "with "
              "the paper's notch; notch_width_min is null"},
        Field{"half_cycles", in(&MotionReport::answer, &Simulation::half_cycles),
              "the first of them, at most --max-half-cycles"},
        Field{"half_cycles_listed",
              [](const MotionReport& report) { return report.answer.half_cycles.size(); }},
        Field{"physical", [](const MotionReport& report) { return physical_of(report); },
              "in the units at the ends of the names; null with dimensionless input; under an "
              "excitation with its end as well"}});

}  // namespace

nlohmann::ordered_json json(const MotionReport& report) {
  return object_by<motion_table>(report);
}

nlohmann::ordered_json simulation_schema() {
  return report_schema<MotionReport>(motion_table, schema_name.front(), "simulate --json");
}

}  // namespace stillpoint::report
