// SPDX-License-Identifier: MIT
#pragma once

// The fields of `physical`: metres, seconds, kilograms, newtons and joules. Null for what does not
// exist, needs a mass that is not known, or is beyond a double.

#include "json/fields.hpp"

#include <stillpoint/core/response_fields.hpp>
#include <stillpoint/design/hits.hpp>
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
#include <vector>

namespace stillpoint::report {

/// What the fields are taken from; what a report does not have is empty.
struct Si {
  design::PhysicalInput input;
  std::optional<double> velocity_m_per_s{}, f{}, delta{}, delta1_published{}, delta1_exact{};
  std::optional<design::Practice> practice{};
  std::optional<double> notch_width_min{};     ///< of ranges that of the worst
  std::optional<double> lambda{}, duration{};  ///< of a wave
  std::optional<double> caught_impulse{};
  const design::Region* region{};
  std::vector<design::Mend> mends{};
  std::optional<design::WorksFor> served{};
  bool of_pulse{false};
  const std::vector<design::Hits>* hits{};
  const Response* motion{};
  const ForcedResponse* forced{};

  [[nodiscard]] const design::Scales& scales() const { return input.scales; }
  [[nodiscard]] design::PhysicalWorksFor works_for() const {
    return physical_works_for(scales(), *served);
  }
  /// Empty if it does not exist, is not finite, or needs a mass that is not known.
  [[nodiscard]] std::optional<double> in_si(Dimension dimension,
                                            const std::optional<double>& value) const;
};

/// A row of the hits.
struct HitsSi {
  double from_m_per_s{0}, to_m_per_s{0};
  std::optional<double> rest_m{};

  static constexpr std::tuple field_table{Field{"from_m_per_s", &HitsSi::from_m_per_s},
                                          Field{"to_m_per_s", &HitsSi::to_m_per_s},
                                          Field{"rest_m", &HitsSi::rest_m, "", any_number}};
};
[[nodiscard]] std::optional<std::vector<HitsSi>> hits_si(const Si& of);

/// The product, if both exist and it is finite.
[[nodiscard]] std::optional<double> times(const std::optional<double>& value,
                                          const std::optional<double>& unit);
/// What would mend an empty region; empty if that input alone cannot.
[[nodiscard]] std::optional<double> mended(const Si& of, std::string_view field, bool by_stiffness);

/// A value of `Si`, which may be empty, in SI units.
template <class Get>
struct Scaled {
  Get get;
  Dimension dimension;

  std::optional<double> operator()(const Si& of) const {
    return of.in_si(dimension, std::invoke(get, of));
  }
};
template <class Get>
Scaled(Get, Dimension) -> Scaled<Get>;

/// The fields of a table that have a physical name, of what `whole` gives.
template <const auto& all, class Whole>
[[nodiscard]] consteval auto twins(Whole whole) {
  const auto twin = [whole]<std::size_t i>(std::integral_constant<std::size_t, i>) {
    constexpr const auto& field = std::get<i>(all);
    if constexpr (field.measure.physical.empty()) {
      return std::tuple{};
    } else {
      return std::tuple{Field{field.measure.physical,
                              Scaled{IfAny{whole, field.get}, field.measure.dimension},
                              {},
                              {field.measure.numbers}}};
    }
  };
  return [twin]<std::size_t... i>(std::index_sequence<i...>) {
    return std::tuple_cat(twin(std::integral_constant<std::size_t, i>())...);
  }
  (std::make_index_sequence<std::tuple_size_v<std::remove_cvref_t<decltype(all)>>>());
}

constexpr auto of_scales(auto design::Scales::*scale) {
  return in(&Si::input, &design::PhysicalInput::scales, scale);
}
inline constexpr auto scale_fields = std::tuple{
    Field{"length_unit_m", of_scales(&design::Scales::length_m)},
    Field{"time_unit_s", of_scales(&design::Scales::time_s)},
    Field{"velocity_unit_m_per_s", of_scales(&design::Scales::velocity_m_per_s)},
    Field{"gravity_m_per_s2", of_scales(&design::Scales::gravity_m_per_s2)},
    Field{"omega_rad_per_s", of_scales(&design::Scales::omega_rad_per_s)},
    Field{"period_s", in(&Si::input, &design::PhysicalInput::period_s)},
    Field{"natural_frequency_hz",
          [](const Si& of) { return of.scales().omega_rad_per_s / (2 * std::numbers::pi); }},
    Field{"mass_kg", of_scales(&design::Scales::mass_kg), "forces and energies need it"},
    Field{"stiffness_n_per_m", [](const Si& of) { return of.scales().stiffness_n_per_m(); }},
    Field{"velocity_m_per_s", &Si::velocity_m_per_s, "", any_number}};

inline constexpr auto region_fields_si = std::tuple{
    Field{"max_displacement_m", [](const Si& of) { return times(of.input.max_displacement_m, 1); }},
    Field{"max_displacement_min_m",
          Scaled{IfAny{&Si::region, &design::Region::beta_min}, Dimension::length}},
    Field{"delta2_m", Scaled{IfAny{&Si::region, &design::Region::delta2}, Dimension::length}, "",
          any_number},
    Field{"velocity_mend_m_per_s", [](const Si& of) { return mended(of, "v0", false); },
          "with the next four: the mends of the region"},
    Field{"period_mend_s", [](const Si& of) { return mended(of, "p", false); }},
    Field{"stiffness_mend_n_per_m",
          [](const Si& of) { return of.scales().mass_kg ? mended(of, "p", true) : std::nullopt; }},
    Field{"max_displacement_mend_m", [](const Si& of) { return mended(of, "beta", false); }},
    Field{"delta_max_mend_m", [](const Si& of) { return mended(of, "delta_max", false); }}};

inline constexpr auto damper_fields =
    std::tuple{Field{"f", [](const Si& of) { return times(of.f, 1); }},
               Field{"delta_m", Scaled{&Si::delta, Dimension::length}},
               Field{"friction_force_n", Scaled{&Si::f, Dimension::force}},
               Field{"energy_per_passage_j", Scaled{&Si::delta, Dimension::energy}}};

inline constexpr auto practice_fields_si = std::tuple{
    Field{"secant_stiffness_n_per_m",
          [](const Si& of) {
            const auto weight = of.scales().friction_force_n(1);
            return of.practice && weight
                       ? times(of.practice->secant_stiffness, *weight / of.scales().length_m)
                       : std::nullopt;
          }},
    Field{"impulse_at_stop_n_s",
          Scaled{IfAny{&Si::practice, &design::Practice::impulse_at_stop}, Dimension::impulse}},
    Field{"impulse_largest_n_s",
          Scaled{IfAny{&Si::practice, &design::Practice::impulse_largest}, Dimension::impulse}},
    Field{"energy_at_stop_j",
          [](const Si& of) {
            return of.practice
                       ? times(of.practice->notch_used,
                               of.scales().energy_per_passage_j(of.practice->notch_capacity))
                       : std::nullopt;
          },
          "what the notch took at the stop, of energy_per_passage_j"},
    Field{"notch_width_min_m", Scaled{&Si::notch_width_min, Dimension::length}}};

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
    Field{"hits", &hits_si, "in the order of those of the report"}};

inline constexpr auto motion_fields_si =
    std::tuple_cat(twins<fields<Response>>(&Si::motion), twins<forced_fields>(&Si::forced));

/// Of a motion and its task, of a damper and its task, and of a motion alone.
struct MotionSi : Si {
  static constexpr auto field_table = std::tuple_cat(
      scale_fields, damper_fields, motion_fields_si, practice_fields_si,
      std::tuple{Field{"caught_impulse_n_s", Scaled{&Si::caught_impulse, Dimension::impulse}}},
      wave_fields);
};
struct AnswerSi : Si {
  static constexpr auto field_table = std::tuple_cat(
      scale_fields, region_fields_si, damper_fields, served_fields_si, practice_fields_si,
      std::tuple{Field{"delta1_published_m", Scaled{&Si::delta1_published, Dimension::length}},
                 Field{"delta1_exact_m", Scaled{&Si::delta1_exact, Dimension::length}}},
      motion_fields_si, wave_fields);
};
struct TwinsSi : Si {
  static constexpr auto field_table = motion_fields_si;
};

[[nodiscard]] std::optional<MotionSi> physical_of(const MotionReport& report);

}  // namespace stillpoint::report
