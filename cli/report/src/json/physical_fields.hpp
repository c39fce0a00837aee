// SPDX-License-Identifier: MIT
#pragma once

// The fields of `physical`: metres, seconds, kilograms, newtons and joules. Null for what does not
// exist, needs a mass that is not known, or is beyond a double.

#include "json/motion_fields.hpp"

#include <cmath>

namespace stillpoint::report {

/// What the fields are taken from; what a report does not have is empty.
struct Si {
  design::PhysicalInput input;
  std::optional<double> velocity_m_per_s{}, f{}, delta{};
  std::optional<design::Practice> practice{};
  std::optional<double> notch_width_min{};     ///< of ranges that of the worst
  std::optional<double> lambda{}, duration{};  ///< of a wave
  std::optional<ShownResponse> motion{};

  [[nodiscard]] const design::Scales& scales() const { return input.scales; }
};

/// The product, if both exist and it is finite.
[[nodiscard]] inline std::optional<double> times(const std::optional<double>& value,
                                                 const std::optional<double>& unit) {
  return value && unit && std::isfinite(*value * *unit) ? std::optional(*value * *unit)
                                                        : std::nullopt;
}

/// The fields of a table that have a physical name, taken as `make` makes of each.
template <const auto& all, class Make>
[[nodiscard]] consteval auto twins(Make make) {
  const auto twin = [make]<std::size_t i>(std::integral_constant<std::size_t, i>) {
    constexpr const auto& field = std::get<i>(all);
    constexpr const Measure& of = field.measure;
    if constexpr (of.physical.empty()) {
      return std::tuple{};
    } else {
      return std::tuple{
          Field{of.physical, make(field.get), {}, si_always(of.dimension, of.numbers)}};
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

inline constexpr auto damper_fields =
    std::tuple{Field{"f", &Si::f}, Field{"delta_m", &Si::delta, "", si_always(Dimension::length)},
               Field{"friction_force_n", &Si::f, "", si_always(Dimension::force)},
               Field{"energy_per_passage_j", &Si::delta, "", si_always(Dimension::energy)}};

inline constexpr auto practice_fields_si = std::tuple_cat(
    std::tuple{Field{"secant_stiffness_n_per_m",
                     [](const Si& of) {
                       const auto weight = of.scales().friction_force_n(1);
                       return of.practice && weight ? times(of.practice->secant_stiffness,
                                                            *weight / of.scales().length_m)
                                                    : std::nullopt;
                     }}},
    twins<fields<design::Practice>>([](auto get) { return in(&Si::practice, get); }),
    std::tuple{Field{"energy_at_stop_j",
                     [](const Si& of) {
                       return of.practice
                                  ? times(of.practice->notch_used, of.scales().energy_per_passage_j(
                                                                       of.practice->notch_capacity))
                                  : std::nullopt;
                     },
                     "what the notch took at the stop, of energy_per_passage_j"},
               Field{"notch_width_min_m", &Si::notch_width_min, "", si_always(Dimension::length)}});

inline constexpr auto motion_fields_si =
    twins<fields<ShownResponse>>([](auto get) { return in(&Si::motion, get); });

inline constexpr auto wave_fields =
    std::tuple{Field{"excitation_rad_per_s",
                     [](const Si& of) { return times(of.lambda, 1 / of.scales().time_s); },
                     "of a pulse or a harmonic; else null"},
               Field{"excitation_frequency_hz",
                     [](const Si& of) {
                       return times(of.lambda, 1 / (2 * std::numbers::pi * of.scales().time_s));
                     }},
               Field{"excitation_duration_s", &Si::duration, "null if it never ends",
                     si_always(Dimension::time)}};

}  // namespace stillpoint::report
