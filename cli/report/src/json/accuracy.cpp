// SPDX-License-Identifier: MIT
#include "json/head_fields.hpp"
#include "json/physical_fields.hpp"
#include "sections.hpp"

namespace stillpoint::report {

namespace {

constexpr auto accuracy_name = std::to_array<std::string_view>({"stillpoint/accuracy-report/1"});
constexpr auto reasons_not_run = std::to_array<std::string_view>({"nothing_moves", "too_long"});

/// The motion in 50 digits, rounded.
struct Truth : peers::Result {
  [[nodiscard]] double final_velocity() const { return outcome == Outcome::running ? v : 0; }

  static constexpr std::tuple field_table{
      Field{"digits", [](const auto& /*now*/) { return 50; }},
      Field{"outcome", &Truth::outcome},
      Field{"peak_amplitude", &Truth::peak, "", si_apart(Dimension::length, "peak_m")},
      Field{"end_time", &Truth::end_time, "", si_apart(Dimension::time, "end_time_s")},
      Field{"final_position", &Truth::x, "",
            si_apart(Dimension::length, "final_position_m", Numbers::all)},
      Field{"final_velocity", &Truth::final_velocity, "",
            si_apart(Dimension::velocity, "final_velocity_m_per_s", Numbers::all)},
      Field{"zero_passages", &Truth::passages},
      Field{"turning_points", &Truth::turns},
      Field{"sticks", &Truth::sticks}};
};
struct TruthSi : Truth {
  static constexpr auto one = [](const Truth& /*now*/) { return 1.0; };
  static constexpr auto field_table =
      std::tuple_cat(std::tuple{Field{"length_unit_m", one, "", si_always(Dimension::length)},
                                Field{"time_unit_s", one, "", si_always(Dimension::time)}},
                     twins<fields<Truth>>([](auto get) { return get; }));
};

/// A method, and whether it is what simulate uses.
struct ShownMethod : peers::MethodRow {
  bool used;

  using Now = ShownMethod;
  using Row = peers::MethodRow;
  using Result = peers::Result;
  static constexpr auto if_run = [](const Row& now) {
    return now.run == peers::Run::done ? &now : nullptr;
  };
  static constexpr auto why_not = [](const Row& now) {
    return now.run == peers::Run::done
               ? std::nullopt
               : std::optional(reasons_not_run.at(now.run == peers::Run::nothing_moves ? 0 : 1));
  };
  static constexpr auto field_table = std::tuple_cat(
      std::tuple{
          Field{"name", &Now::name},
          Field{"setting", [](const Row& now) { return report::setting(now); }, "", any_number},
          Field{"used_by_simulate", &Now::used}},
      fields_in(
          if_run,
          std::tuple{
              Field{"wall_time_s", [](const Row& timed) { return timed.time.median; },
                    "the median of repeated runs; null, like all that follows, for a method that "
                    "was not run"},
              Field{"peak_error", &Row::peak_error, "relative to the peak"},
              Field{"end_error", &Row::end_error,
                    "the larger of the errors of x, relative to the peak, and of the stop time, "
                    "relative to itself, or if the motion goes on, of v at the end, relative to "
                    "p times the peak"},
              Field{"zero_passages", in(&Row::result, &Result::passages)},
              Field{"turning_points", in(&Row::result, &Result::turns)},
              Field{"sticks", in(&Row::result, &Result::sticks)},
              Field{"counts_right", &Row::counts_right}}),
      std::tuple{Field{"not_run", why_not, "null if it was run", one_of(reasons_not_run)}});
};

std::vector<ShownMethod> shown_methods(const AccuracyReport& report) {
  std::vector<ShownMethod> methods;
  for (const peers::MethodRow& now : report.comparison.rows) {
    methods.push_back({now, methods.empty()});
  }
  return methods;
}

Truth truth_of(const AccuracyReport& report) {
  return {report.comparison.exact.rounded};
}

constexpr auto accuracy_table = std::tuple_cat(
    head_fields<AccuracyReport, accuracy_name>,
    std::tuple{
        Field{"input", motion_input}, Field{"reference", &truth_of},
        Field{"methods", &shown_methods, "", {Numbers::from_one}},
        Field{"why", [](const AccuracyReport& report) { return reason(report.request); },
              "why simulate uses its method"},
        Field{"physical", [](const AccuracyReport& report) { return TruthSi{truth_of(report)}; },
              "the reference in metres and seconds; null with dimensionless input",
              si_alone(Dimension::none)}});

}  // namespace

nlohmann::ordered_json json(const AccuracyReport& report) {
  return object_by<accuracy_table>(report, scales_of(report.physical));
}

nlohmann::ordered_json accuracy_schema() {
  return report_schema<AccuracyReport>(accuracy_table, accuracy_name.front(), "accuracy --json");
}

}  // namespace stillpoint::report
