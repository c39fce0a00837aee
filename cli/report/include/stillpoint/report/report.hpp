// SPDX-License-Identifier: MIT
#pragma once

// What to report for each answer, in three ways: a document for people, a
// page of figures for a browser, JSON for programs.

#include <stillpoint/core/simulation.hpp>
#include <stillpoint/design/built_notch.hpp>
#include <stillpoint/design/catalogue.hpp>
#include <stillpoint/design/design.hpp>
#include <stillpoint/design/finding.hpp>
#include <stillpoint/design/physical.hpp>
#include <stillpoint/design/region.hpp>
#include <stillpoint/design/trade_off.hpp>
#include <stillpoint/peers/comparison.hpp>
#include <stillpoint/report/document.hpp>

#include <nlohmann/json.hpp>

#include <cstdint>
#include <optional>
#include <span>

namespace stillpoint::report {

/// The parts of a file, best first.
struct Catalogue {
  std::string file;
  std::vector<design::RatedPart> parts;
};

/// If the input was given in metres and seconds, `physical` has it, and reports are in both.
struct DesignReport {
  design::DesignResult result;
  std::optional<design::PhysicalInput> physical{};
  std::optional<design::BuiltNotch> built_notch{};  ///< of the finding, if a width was given
  std::optional<Catalogue> catalogue{};             ///< of which the finding is the best
  std::optional<std::int64_t> trade_offs{};         ///< how many were asked for
  std::optional<std::vector<design::TradeOff>> trade_off{};
  std::vector<design::Finding> findings{};
};

struct RegionReport {
  design::RegionRequest request;
  design::RegionAnswer answer;
  std::optional<design::PhysicalInput> physical{};
  std::optional<Catalogue> catalogue{};
  std::vector<design::Finding> findings{};
};

/// Where an acceleration record comes from.
struct RecordOrigin {
  std::string file;
  std::string description;           ///< what the file says of itself
  std::optional<std::string> units;  ///< these as asked for
  std::optional<double> step;
  std::optional<double> scale;
  std::optional<double> peak;  ///< to be scaled to, in g, as the next
  std::optional<double> spectrum;
  std::optional<double> spectrum_period;
  double factor{1};        ///< that the values of the file were multiplied by
  std::string units_read;  ///< of the values in the file
  bool assumed{false};     ///< neither the file nor the options give them
};

struct MotionReport {
  SimulationRequest request;
  Simulation answer;
  std::optional<RecordOrigin> record{};  ///< where the excitation comes from
  std::optional<design::PhysicalInput> physical{};
  std::vector<design::Finding> findings{};
};

/// The motion of `request` by each method.
struct AccuracyReport {
  SimulationRequest request;
  peers::Comparison comparison;
  std::optional<RecordOrigin> record{};
  std::optional<design::PhysicalInput> physical{};
};

[[nodiscard]] Document document(const DesignReport& report);
[[nodiscard]] Document document(const RegionReport& report);
[[nodiscard]] Document document(const MotionReport& report);
[[nodiscard]] Document document(const AccuracyReport& report);

/// The answer in a sentence or two; what else is to be known of it, the findings say.
[[nodiscard]] std::string verdict(const DesignReport& report);
[[nodiscard]] std::string verdict(const RegionReport& report);
[[nodiscard]] std::string verdict(const MotionReport& report);

/// As docs/reports.md describes them. Numbers carry a double's full precision; a value that does
/// not exist is null.
[[nodiscard]] nlohmann::ordered_json json(const DesignReport& report);
[[nodiscard]] nlohmann::ordered_json json(const RegionReport& report);
[[nodiscard]] nlohmann::ordered_json json(const MotionReport& report);
[[nodiscard]] nlohmann::ordered_json json(const AccuracyReport& report);
/// As the program writes it: indented, with a final newline. A number that is not finite is an
/// assertion.
[[nodiscard]] std::string json_text(const nlohmann::ordered_json& json);

[[nodiscard]] std::vector<figures::Figure> drawings(const DesignReport& report);
[[nodiscard]] std::vector<figures::Figure> drawings(const RegionReport& report);
[[nodiscard]] std::vector<figures::Figure> drawings(const MotionReport& report);

/// The columns of a trajectory: the members of TracedState, and with physical input the same in
/// metres and seconds.
[[nodiscard]] std::vector<std::string_view> trajectory_columns(
    const std::optional<design::PhysicalInput>& physical);
/// Their values, one state after the other.
[[nodiscard]] std::vector<double> trajectory_rows(
    std::span<const TracedState> states, const std::optional<design::PhysicalInput>& physical);
/// The same as text, a line for each state.
[[nodiscard]] std::string trajectory_csv(const std::vector<TracedState>& states,
                                         const std::optional<design::PhysicalInput>& physical);

}  // namespace stillpoint::report
