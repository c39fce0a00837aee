// SPDX-License-Identifier: MIT
#pragma once

// The fields of `physical`: metres, seconds, kilograms, newtons and joules. Null for what does not
// exist, needs a mass that is not known, or is beyond a double.

#include "json/fields.hpp"

#include <stillpoint/core/response_fields.hpp>
#include <stillpoint/design/physical.hpp>
#include <stillpoint/design/practice.hpp>
#include <stillpoint/design/works_for.hpp>
#include <stillpoint/report/report.hpp>

#include <array>
#include <cstddef>
#include <functional>
#include <numbers>
#include <optional>
#include <tuple>
#include <utility>
#include <variant>
#include <vector>

namespace stillpoint::report {

/// What the fields are taken from; what a report does not have is empty.
struct Si {
  design::PhysicalInput input;
  std::optional<double> velocity_m_per_s{};
  const design::RegionVerdict* region{};
  std::optional<double> f{};
  std::optional<double> delta{};
  std::optional<design::WorksFor> served{};
  bool of_pulse{false};
  std::optional<std::vector<design::Hits>> hits{};
  std::optional<design::Practice> practice{};
  std::optional<double> notch_width_min{};  ///< of ranges that of the worst
  std::optional<double> delta1_published{};
  std::optional<double> delta1_exact{};
  const Response* motion{};
  const ForcedResponse* forced{};
  std::optional<double> caught_impulse{};
  std::optional<double> lambda{};  ///< of a wave
  std::optional<double> duration{};

  [[nodiscard]] const design::Scales& scales() const { return input.scales; }
  [[nodiscard]] design::PhysicalWorksFor works_for() const {
    return physical_works_for(scales(), *served);
  }
  /// Empty if it does not exist, is not finite, or needs a mass that is not known.
  [[nodiscard]] std::optional<double> in_si(Dimension dimension,
                                            const std::optional<double>& value) const;
  [[nodiscard]] std::optional<double> length(const std::optional<double>& value) const {
    return in_si(Dimension::length, value);
  }
};

/// A row of the hits.
struct HitsSi {
  double from_m_per_s{0};
  double to_m_per_s{0};
  std::optional<double> rest_m{};
};
[[nodiscard]] std::vector<HitsSi> hits_si(const Si& of);

/// The product, if both exist and it is finite.
[[nodiscard]] std::optional<double> times(const std::optional<double>& value,
                                          const std::optional<double>& unit);
/// What would mend an empty region; empty if that input alone cannot.
[[nodiscard]] std::optional<double> mended(const Si& of, std::string_view field, bool by_stiffness);

/// A figure of a motion in SI units.
template <class Get, class Motion>
struct TwinOf {
  Get get;
  Dimension dimension;
  const Motion* Si::*motion;

  std::optional<double> operator()(const Si& of) const {
    const Motion* const from = of.*motion;
    return from == nullptr ? std::nullopt
                           : of.in_si(dimension, std::optional<double>(std::invoke(get, *from)));
  }
};

/// The fields of a table that have a physical name.
template <const auto& all, class Motion>
[[nodiscard]] consteval auto twins(const Motion* Si::*motion) {
  const auto twin = [motion]<std::size_t i>(std::integral_constant<std::size_t, i>) {
    constexpr const auto& field = std::get<i>(all);
    if constexpr (field.measure.physical.empty()) {
      return std::tuple{};
    } else {
      const auto& [numbers, dimension, physical, texts, si] = field.measure;
      return std::tuple{Field{
          physical,
          TwinOf<std::remove_cvref_t<decltype(field.get)>, Motion>{field.get, dimension, motion},
          {},
          {numbers}}};
    }
  };
  return [twin]<std::size_t... i>(std::index_sequence<i...>) {
    return std::tuple_cat(twin(std::integral_constant<std::size_t, i>())...);
  }
  (std::make_index_sequence<std::tuple_size_v<std::remove_cvref_t<decltype(all)>>>());
}

inline constexpr Measure any_number{Numbers::all};

inline constexpr auto scale_fields = std::tuple{
    Field{"length_unit_m", [](const Si& of) { return of.scales().length_m; }},
    Field{"time_unit_s", [](const Si& of) { return of.scales().time_s; }},
    Field{"velocity_unit_m_per_s", [](const Si& of) { return of.scales().velocity_m_per_s; }},
    Field{"gravity_m_per_s2", [](const Si& of) { return of.scales().gravity_m_per_s2; }},
    Field{"omega_rad_per_s", [](const Si& of) { return of.scales().omega_rad_per_s; }},
    Field{"period_s", [](const Si& of) { return of.input.period_s; }},
    Field{"natural_frequency_hz",
          [](const Si& of) { return of.scales().omega_rad_per_s / (2 * std::numbers::pi); }},
    Field{"mass_kg", [](const Si& of) { return of.scales().mass_kg; },
          "forces and energies need it"},
    Field{"stiffness_n_per_m", [](const Si& of) { return of.scales().stiffness_n_per_m(); }},
    Field{"velocity_m_per_s", &Si::velocity_m_per_s, "", any_number}};

inline constexpr auto region_fields_si = std::tuple{
    Field{"max_displacement_m", [](const Si& of) { return times(of.input.max_displacement_m, 1); }},
    Field{"max_displacement_min_m",
          [](const Si& of) { return of.length(of.region->region.beta_min); }},
    Field{"delta2_m", [](const Si& of) { return of.length(of.region->region.delta2); }, "",
          any_number},
    Field{"velocity_mend_m_per_s", [](const Si& of) { return mended(of, "v0", false); },
          "with the next four: the mends of the region"},
    Field{"period_mend_s", [](const Si& of) { return mended(of, "p", false); }},
    Field{"stiffness_mend_n_per_m",
          [](const Si& of) { return of.scales().mass_kg ? mended(of, "p", true) : std::nullopt; }},
    Field{"max_displacement_mend_m", [](const Si& of) { return mended(of, "beta", false); }},
    Field{"delta_max_mend_m", [](const Si& of) { return mended(of, "delta_max", false); }}};

inline constexpr auto damper_fields = std::tuple{
    Field{"f", [](const Si& of) { return times(of.f, 1); }},
    Field{"delta_m", [](const Si& of) { return of.length(of.delta); }},
    Field{"friction_force_n", [](const Si& of) { return of.in_si(Dimension::force, of.f); }},
    Field{"energy_per_passage_j",
          [](const Si& of) { return of.in_si(Dimension::energy, of.delta); }}};

inline constexpr auto practice_fields_si = std::tuple{
    Field{"secant_stiffness_n_per_m",
          [](const Si& of) {
            const auto weight = of.scales().friction_force_n(1);
            return of.practice && weight
                       ? times(of.practice->secant_stiffness, *weight / of.scales().length_m)
                       : std::nullopt;
          }},
    Field{"impulse_at_stop_n_s",
          [](const Si& of) {
            return of.practice ? times(of.practice->impulse_at_stop, of.scales().impulse_n_s(1))
                               : std::nullopt;
          }},
    Field{"impulse_largest_n_s",
          [](const Si& of) {
            return of.practice ? times(of.practice->impulse_largest, of.scales().impulse_n_s(1))
                               : std::nullopt;
          }},
    Field{"energy_at_stop_j",
          [](const Si& of) {
            return of.practice
                       ? times(of.practice->notch_used,
                               of.scales().energy_per_passage_j(of.practice->notch_capacity))
                       : std::nullopt;
          },
          "what the notch took at the stop, of energy_per_passage_j"},
    Field{"notch_width_min_m", [](const Si& of) { return of.length(of.notch_width_min); }}};

inline constexpr auto wave_fields =
    std::tuple{Field{"excitation_rad_per_s",
                     [](const Si& of) { return times(of.lambda, 1 / of.scales().time_s); },
                     "of a pulse or a harmonic; else null"},
               Field{"excitation_frequency_hz",
                     [](const Si& of) {
                       return times(of.lambda, 1 / (2 * std::numbers::pi * of.scales().time_s));
                     }},
               Field{"excitation_duration_s",
                     [](const Si& of) { return times(of.duration, of.scales().time_s); },
                     "null if it never ends"}};

inline constexpr auto served_fields_si = std::tuple{
    Field{"works_for_velocity_m_per_s",
          [](const Si& of) {
            return of.served && !of.of_pulse ? std::optional(of.works_for().velocity_m_per_s)
                                             : std::nullopt;
          }},
    Field{"works_for_period_s",
          [](const Si& of) {
            return of.served ? std::optional(of.works_for().period_s) : std::nullopt;
          }},
    Field{"hits", [](const Si& of) { return of.hits ? std::optional(hits_si(of)) : std::nullopt; },
          "in the order of those of the report"}};

/// Of a free and of a forced motion, of a design and of a region.
struct MotionSi : Si {};
struct ForcedMotionSi : Si {};
struct DesignSi : Si {};
struct RegionSi : Si {};

[[nodiscard]] std::optional<DesignSi> physical_of(const DesignReport& report);
[[nodiscard]] std::optional<RegionSi> physical_of(const RegionReport& report);
using AnyMotionSi = std::variant<MotionSi, ForcedMotionSi>;
[[nodiscard]] std::optional<AnyMotionSi> physical_of(const MotionReport& report);

}  // namespace stillpoint::report

namespace stillpoint {

template <>
inline constexpr auto fields<report::HitsSi> =
    std::tuple{Field{"from_m_per_s", &report::HitsSi::from_m_per_s},
               Field{"to_m_per_s", &report::HitsSi::to_m_per_s},
               Field{"rest_m", &report::HitsSi::rest_m, "", report::any_number}};

template <>
inline constexpr auto fields<report::MotionSi> = std::tuple_cat(
    report::scale_fields, report::damper_fields,
    report::twins<fields<Response>>(&report::Si::motion), report::practice_fields_si,
    std::tuple{Field{"caught_impulse_n_s",
                     [](const report::Si& of) {
                       return report::times(of.caught_impulse, of.scales().impulse_n_s(1));
                     }}},
    report::wave_fields);

template <>
inline constexpr auto fields<report::ForcedMotionSi> =
    std::tuple_cat(fields<report::MotionSi>, report::twins<forced_fields>(&report::Si::forced));

template <>
inline constexpr auto fields<report::DesignSi> =
    std::tuple_cat(report::scale_fields, report::region_fields_si, report::damper_fields,
                   report::served_fields_si, report::practice_fields_si,
                   report::twins<fields<Response>>(&report::Si::motion), report::wave_fields);

template <>
inline constexpr auto fields<report::RegionSi> = std::tuple_cat(
    report::scale_fields, report::region_fields_si, report::damper_fields, report::served_fields_si,
    report::practice_fields_si,
    std::tuple{
        Field{"delta1_published_m",
              [](const report::Si& of) { return of.length(of.delta1_published); }},
        Field{"delta1_exact_m", [](const report::Si& of) { return of.length(of.delta1_exact); }}},
    report::wave_fields);

}  // namespace stillpoint
