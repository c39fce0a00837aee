// SPDX-License-Identifier: MIT
#pragma once

// The fields of the report of one motion, some of which other reports have too.

#include "json/physical_fields.hpp"

#include <stillpoint/core/response_fields.hpp>
#include <stillpoint/core/simulation.hpp>
#include <stillpoint/design/practice.hpp>
#include <stillpoint/records/record_file.hpp>
#include <stillpoint/report/report.hpp>
#include <stillpoint/report/version.hpp>

#include <array>
#include <optional>
#include <string>
#include <string_view>
#include <tuple>
#include <utility>
#include <vector>

namespace stillpoint::report {

/// An excitation: empty is what a type does not have.
struct ShownExcitation {
  std::string_view type;
  std::optional<double> k{};
  std::optional<double> lambda{};
  std::optional<double> phase{};
  std::optional<double> duration{};
  std::optional<std::size_t> samples{};
  std::optional<double> pga{};
  std::optional<RecordOrigin> record{};
};
[[nodiscard]] std::optional<ShownExcitation> shown(const Excitation& excitation,
                                                   const std::optional<RecordOrigin>& record);

/// The input of a motion.
struct ShownMotion : SimulationRequest {
  std::optional<RecordOrigin> record;
};

/// With the impulses of the motion, if they are shown.
struct ShownPractice : design::Practice {
  std::optional<std::vector<double>> impulses{};
};

struct Program {};
struct Version {
  std::string text;
};
[[nodiscard]] nlohmann::ordered_json own_json(const Version& version);
[[nodiscard]] nlohmann::ordered_json own_schema(const Version* version);

/// Of the record's origin, of an excitation that is a record.
template <class Member>
constexpr auto of_record(Member RecordOrigin::*member) {
  return IfAny{&ShownExcitation::record, member};
}

inline constexpr auto program_names = std::to_array<std::string_view>({"stillpoint"});
inline constexpr auto excitation_types =
    std::to_array<std::string_view>({"harmonic", "half-sine", "full-sine", "rectangle", "record"});
inline constexpr auto record_units =
    std::to_array<std::string_view>({"g", "m/s2", "cm/s2", "mm/s2"});

/// A motion; without a load it has no ForcedResponse.
struct ShownResponse {
  const Response* response;
  const ForcedResponse* forced;

  explicit ShownResponse(const Response& free) : response(&free), forced(nullptr) {}
  explicit ShownResponse(const ForcedResponse& under_load)
      : response(&under_load), forced(&under_load) {}
};

}  // namespace stillpoint::report

namespace stillpoint {

template <>
inline constexpr auto fields<report::Program> =
    std::tuple{Field{"name",
                     [](const report::Program&) { return report::program_names.front(); },
                     "",
                     {.texts = report::program_names}},
               Field{"version", [](const report::Program&) {
                       return report::Version{report::program_version()};
                     }}};

template <>
inline constexpr auto fields<FrictionZone> =
    std::tuple{Field{"to", &FrictionZone::to}, Field{"f", &FrictionZone::f}};

template <>
inline constexpr auto fields<report::ShownExcitation> = std::tuple{
    Field{"type", &report::ShownExcitation::type, "", {.texts = report::excitation_types}},
    Field{"k", &report::ShownExcitation::k, "", {Numbers::all}},
    Field{"lambda", &report::ShownExcitation::lambda},
    Field{"phase", &report::ShownExcitation::phase, "", {Numbers::all}},
    Field{"duration", &report::ShownExcitation::duration, "null if it never ends"},
    Field{"record", report::of_record(&report::RecordOrigin::file)},
    Field{"samples", &report::ShownExcitation::samples},
    Field{"record_units",
          report::of_record(&report::RecordOrigin::units),
          "",
          {.texts = report::record_units}},
    Field{"record_step", report::of_record(&report::RecordOrigin::step)},
    Field{"record_scale", report::of_record(&report::RecordOrigin::scale), "", {Numbers::all}},
    Field{"record_peak", report::of_record(&report::RecordOrigin::peak)},
    Field{"record_spectrum", report::of_record(&report::RecordOrigin::spectrum)},
    Field{"record_spectrum_period", report::of_record(&report::RecordOrigin::spectrum_period)},
    Field{"record_units_read",
          report::of_record(&report::RecordOrigin::units_read),
          "of the values in the file",
          {.texts = report::record_units}},
    Field{"record_units_assumed", report::of_record(&report::RecordOrigin::assumed),
          "whether neither the file nor an option gives them"},
    Field{"record_factor",
          report::of_record(&report::RecordOrigin::factor),
          "on the values in the file",
          {Numbers::all}},
    Field{"pga", &report::ShownExcitation::pga, "the largest |W|, with that factor"}};

template <>
inline constexpr auto fields<report::ShownResponse> = std::tuple_cat(
    std::apply(
        [](const auto&... field) {
          return std::tuple{
              Field{field.name,
                    in(
                        [](const auto& now) -> const auto& { return *now.response; }, field.get),
                    field.words, field.measure}...};
        },
        fields<Response>),
    report::fields_if_any(&report::ShownResponse::forced, forced_fields));

template <>
inline constexpr auto fields<report::ShownMotion> = [] {
  using Now = report::ShownMotion;
  return std::tuple{
      Field{"v0", in(&Now::start, &Start::v0), "", {Numbers::all}},
      Field{"p", in(&Now::oscillator, &Oscillator::p)},
      Field{"f", in(&Now::oscillator, &Oscillator::f)},
      Field{"delta", in(&Now::oscillator, &Oscillator::delta)},
      Field{"x0", in(&Now::start, &Start::x0), "", {Numbers::all}},
      Field{"t_end", &Now::t_end},
      Field{"excitation", [](const Now& now) { return report::shown(now.excitation, now.record); },
            "null for what a type does not have"},
      Field{"hold", in(&Now::oscillator, &Oscillator::hold),
            "the load that the notch holds at x = 0 besides f; null: any load"},
      Field{"notch_width", in(&Now::surface, &Surface::notch_width),
            "null: none, the notch acts only at x = 0"},
      Field{"friction_zones",
            [](const Now& now) {
              const auto& zones = now.surface.zones;
              return zones.empty() ? std::nullopt : std::optional(zones);
            },
            "friction f for |x| < to, from the zone before it on; beyond the last the motion's own "
            "f",
            {Numbers::from_one}}};
}();

template <>
inline constexpr auto fields<HalfCycle> = std::tuple{
    Field{"index", &HalfCycle::index, "", {Numbers::from_one}},
    Field{"side", &HalfCycle::side, "the sign of x", {Numbers::all}},
    Field{"start_time", &HalfCycle::start_time,
          "tau; the release where the mass is held from its start"},
    Field{"departure_speed", &HalfCycle::departure_speed},
    Field{"peak_time", &HalfCycle::peak_time},
    Field{"peak", &HalfCycle::peak},
    Field{"end_time", &HalfCycle::end_time},
    Field{"end_position", &HalfCycle::end_position, "", {Numbers::all}},
    Field{"arrival_speed", &HalfCycle::arrival_speed, "null if it rests off x = 0"},
    Field{"impulse", &HalfCycle::impulse,
          "the impulse of the notch at its end that the structure feels, per mass; null if it does "
          "not end at x = 0 or the notch has a width"}};

template <>
inline constexpr auto fields<report::ShownPractice> = [] {
  using Now = report::ShownPractice;
  return std::tuple{
      Field{"secant_stiffness", &Now::secant_stiffness, "at the peak; the spring's is p^2"},
      Field{"equivalent_damping", &Now::equivalent_damping,
            "of a full cycle at that peak; null above 1"},
      Field{"base_shear_over_weight", &Now::base_shear},
      Field{"restoring_over_weight", &Now::restoring},
      Field{"energy_ratio", &Now::energy_ratio, "E_s/E_h (EN 15129)"},
      Field{"residual_ratio", &Now::residual_ratio, "d/d_rm (EN 1998-2)"},
      Field{
          "impulse_at_stop", &Now::impulse_at_stop, "per mass", {.dimension = Dimension::velocity}},
      Field{"impulse_largest", &Now::impulse_largest, "", {.dimension = Dimension::velocity}},
      Field{"impulses", &Now::impulses,
            "of each passage and of the stop at x = 0, in turn; at most the last 1000; null in "
            "practice_worst"},
      Field{"notch_capacity",
            &Now::notch_capacity,
            "what a whole passage takes",
            {.dimension = Dimension::length}},
      Field{"notch_used", &Now::notch_used, "the share of it that the stop took"},
      Field{"notch_width_min",
            &Now::notch_width_min,
            "the least width with which the mass feels no more than acceleration_max inside the "
            "notch; null without it, or if there is none",
            {.dimension = Dimension::length}}};
}();

}  // namespace stillpoint
