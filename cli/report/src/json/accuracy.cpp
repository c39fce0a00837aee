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

  static constexpr std::tuple field_table{
      Field{"digits", [](const Truth&) { return 50; }},
      Field{"outcome", &Truth::outcome},
      Field{"peak_amplitude", &Truth::peak},
      Field{"end_time", &Truth::end_time},
      Field{"final_position", &Truth::x, "", any_number},
      Field{"final_velocity", &Truth::final_velocity, "", any_number},
      Field{"zero_passages", &Truth::passages},
      Field{"turning_points", &Truth::turns},
      Field{"sticks", &Truth::sticks}};
};
struct TruthSi : Truth {
  static constexpr Measure signed_length{Numbers::all, Dimension::length, {}, {}, InSi::always};
  static constexpr Measure signed_velocity{Numbers::all, Dimension::velocity, {}, {}, InSi::always};
  static constexpr std::tuple field_table{
      Field{"length_unit_m", in(&Truth::scales, &design::Scales::length_m)},
      Field{"time_unit_s", in(&Truth::scales, &design::Scales::time_s)},
      Field{"peak_m", &Truth::peak, "", si_always(Dimension::length)},
      Field{"end_time_s", &Truth::end_time, "", si_always(Dimension::time)},
      Field{"final_position_m", &Truth::x, "", signed_length},
      Field{"final_velocity_m_per_s", &Truth::final_velocity, "", signed_velocity}};
};

/// A method, and whether it is what simulate uses.
struct ShownMethod {
  const peers::MethodRow& row;
  bool used{false};

  [[nodiscard]] const peers::MethodRow* run() const {
    return row.run == peers::Run::done ? &row : nullptr;
  }
  using Now = ShownMethod;
  using MethodRow = peers::MethodRow;
  using Result = peers::Result;
  static constexpr auto field_table = std::tuple_cat(
        std::tuple{Field{"name", [](const auto& now) { return now.row.name; }},
                   Field{"setting", [](const auto& now) { return setting(now.row); }, "",
                         any_number},
                   Field{"used_by_simulate", &Now::used}},
        fields_if_any(
            &Now::run,
            std::tuple{
                Field{"wall_time_s", [](const MethodRow& shown) { return shown.time.median; },
                      "the median of repeated runs; null, like all that follows, for a method that "
                      "was not run"},
                Field{"peak_error", &MethodRow::peak_error, "relative to the peak"},
                Field{"end_error", &MethodRow::end_error,
                      "the larger of the errors of x, relative to the peak, and of the stop time, "
                      "relative to itself, or if the motion goes on, of v at the end, relative to "
                      "p times the peak"},
                Field{"zero_passages", in(&MethodRow::result, &Result::passages)},
                Field{"turning_points", in(&MethodRow::result, &Result::turns)},
                Field{"sticks", in(&MethodRow::result, &Result::sticks)},
                Field{"counts_right", &MethodRow::counts_right}}),
        std::tuple{Field{"not_run",
                         [](const auto& now) {
                           return now.run() != nullptr
                                      ? std::nullopt
                                      : std::optional(reasons_not_run.at(
                                            now.row.run == peers::Run::nothing_moves ? 0 : 1));
                         },
                         "null if it was run", one_of(reasons_not_run)}});
};

std::vector<ShownMethod> shown_methods(const AccuracyReport& report) {
  std::vector<ShownMethod> methods;
  for (const peers::MethodRow& now : report.comparison.rows) {
    methods.push_back({now, methods.empty()});
  }
  return methods;
}

constexpr auto accuracy_table = std::tuple_cat(
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

}  // namespace

nlohmann::ordered_json json(const AccuracyReport& report) {
  return object_by<accuracy_table>(report, scales_of(report.physical));
}

nlohmann::ordered_json accuracy_schema() {
  return report_schema<AccuracyReport>(accuracy_table, accuracy_name.front(), "accuracy --json");
}

}  // namespace stillpoint::report
