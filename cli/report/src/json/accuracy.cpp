// SPDX-License-Identifier: MIT
#include "json/head_fields.hpp"
#include "json/motion_fields.hpp"
#include "json/schema.hpp"
#include "sections.hpp"

#include <stillpoint/peers/comparison.hpp>
#include <stillpoint/report/schemas.hpp>

#include <array>
#include <optional>
#include <string_view>
#include <tuple>

namespace stillpoint::report {

namespace {

constexpr auto accuracy_name = std::to_array<std::string_view>({"stillpoint/accuracy-report/1"});
constexpr auto reasons_not_run = std::to_array<std::string_view>({"nothing_moves", "too_long"});

/// The motion in 50 digits, rounded.
struct Truth : peers::Result {
  design::Scales scales{};

  [[nodiscard]] double final_velocity() const { return outcome == Outcome::running ? v : 0; }
};
struct TruthSi : Truth {};

/// A method, and whether it is what simulate uses.
struct ShownMethod {
  const peers::MethodRow& row;
  bool used{false};
};

/// What only a method that was run has.
template <class Get>
struct IfRun {
  Get get;
  auto operator()(const ShownMethod& now) const {
    const auto value = get(now.row);
    return now.row.run == peers::Run::done ? std::optional(value) : std::nullopt;
  }
};
template <class Get>
IfRun(Get) -> IfRun<Get>;

std::vector<ShownMethod> shown_methods(const AccuracyReport& report) {
  std::vector<ShownMethod> methods;
  for (const peers::MethodRow& now : report.comparison.rows) {
    methods.push_back({now, methods.empty()});
  }
  return methods;
}

}  // namespace

}  // namespace stillpoint::report

namespace stillpoint {

template <>
inline constexpr auto fields<report::Truth> = [] {
  using report::Truth;
  return std::tuple{Field{"digits", [](const Truth&) { return 50; }},
                    Field{"outcome", &Truth::outcome},
                    Field{"peak_amplitude", &Truth::peak},
                    Field{"end_time", &Truth::end_time},
                    Field{"final_position", &Truth::x, "", {Numbers::all}},
                    Field{"final_velocity", &Truth::final_velocity, "", {Numbers::all}},
                    Field{"zero_passages", &Truth::passages},
                    Field{"turning_points", &Truth::turns},
                    Field{"sticks", &Truth::sticks}};
}();

template <>
inline constexpr auto fields<report::TruthSi> = [] {
  using report::Truth;
  return std::tuple{
      Field{"length_unit_m", in(&Truth::scales, &design::Scales::length_m)},
      Field{"time_unit_s", in(&Truth::scales, &design::Scales::time_s)},
      Field{"peak_m", [](const Truth& now) { return now.peak * now.scales.length_m; }},
      Field{"end_time_s", [](const Truth& now) { return now.end_time * now.scales.time_s; }},
      Field{"final_position_m",
            [](const Truth& now) { return now.x * now.scales.length_m; },
            "",
            {Numbers::all}},
      Field{"final_velocity_m_per_s",
            [](const Truth& now) { return now.final_velocity() * now.scales.velocity_m_per_s; },
            "",
            {Numbers::all}}};
}();

template <>
inline constexpr auto fields<report::ShownMethod> = [] {
  using peers::MethodRow;
  using report::IfRun;
  using report::ShownMethod;
  return std::tuple{
      Field{"name", [](const ShownMethod& now) { return now.row.name; }},
      Field{"setting",
            [](const ShownMethod& now) { return report::setting(now.row); },
            "",
            {Numbers::all}},
      Field{"used_by_simulate", &ShownMethod::used},
      Field{"wall_time_s", IfRun{[](const MethodRow& row) { return row.time.median; }},
            "the median of repeated runs; null, like all that follows, for a method that was not "
            "run"},
      Field{"peak_error", IfRun{[](const MethodRow& row) { return row.peak_error; }},
            "relative to the peak"},
      Field{"end_error", IfRun{[](const MethodRow& row) { return row.end_error; }},
            "the larger of the errors of x, relative to the peak, and of the stop time, relative "
            "to itself, or if the motion goes on, of v at the end, relative to p times the peak"},
      Field{"zero_passages", IfRun{[](const MethodRow& row) { return row.result.passages; }}},
      Field{"turning_points", IfRun{[](const MethodRow& row) { return row.result.turns; }}},
      Field{"sticks", IfRun{[](const MethodRow& row) { return row.result.sticks; }}},
      Field{"counts_right", IfRun{[](const MethodRow& row) { return row.counts_right; }}},
      Field{"not_run",
            [](const ShownMethod& now) {
              return now.row.run == peers::Run::done
                         ? std::nullopt
                         : std::optional(report::reasons_not_run.at(
                               now.row.run == peers::Run::nothing_moves ? 0 : 1));
            },
            "null if it was run",
            {.texts = report::reasons_not_run}}};
}();

template <>
inline constexpr auto fields<report::AccuracyReport> = [] {
  using namespace report;
  return std::tuple_cat(
      head_fields<AccuracyReport, accuracy_name>,
      std::tuple{Field{"input",
                       [](const AccuracyReport& report) {
                         return ShownMotion{{report.request}, report.record};
                       }},
                 Field{"reference",
                       [](const AccuracyReport& report) {
                         return Truth{{report.comparison.exact.rounded}};
                       }},
                 Field{"methods", &shown_methods, "", {Numbers::from_one}},
                 Field{"why", [](const AccuracyReport& report) { return reason(report.request); },
                       "why simulate uses its method"},
                 Field{"physical",
                       [](const AccuracyReport& report) {
                         return report.physical
                                    ? std::optional(TruthSi{{{report.comparison.exact.rounded},
                                                             report.physical->scales}})
                                    : std::nullopt;
                       },
                       "the reference in metres and seconds; null with dimensionless input"}});
}();

}  // namespace stillpoint

namespace stillpoint::report {

nlohmann::ordered_json json(const AccuracyReport& report) {
  return object_json(report);
}

nlohmann::ordered_json accuracy_schema() {
  return document_schema(accuracy_name.front(), "accuracy --json", dimensionless_numbers,
                         schema_of<AccuracyReport>());
}

}  // namespace stillpoint::report
