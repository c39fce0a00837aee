// SPDX-License-Identifier: MIT
#pragma once

// The fields of the report of one motion, some of which other reports have too.

#include "json/fields.hpp"

#include <stillpoint/core/response_fields.hpp>
#include <stillpoint/records/record_file.hpp>

namespace stillpoint {

template <>
inline constexpr auto fields<FrictionZone> =
    std::tuple{Field{"to", &FrictionZone::to}, Field{"f", &FrictionZone::f}};

template <>
inline constexpr auto fields<HalfCycle> = std::tuple{
    Field{"index", &HalfCycle::index, "", at_least_one},
    Field{"side", &HalfCycle::side, "the sign of x", any_number},
    Field{"start_time", &HalfCycle::start_time,
          "tau; the release where the mass is held from its start"},
    Field{"departure_speed", &HalfCycle::departure_speed},
    Field{"peak_time", &HalfCycle::peak_time},
    Field{"peak", &HalfCycle::peak},
    Field{"end_time", &HalfCycle::end_time},
    Field{"end_position", &HalfCycle::end_position, "", any_number},
    Field{"arrival_speed", &HalfCycle::arrival_speed, "null if it rests off x = 0"},
    Field{"impulse", &HalfCycle::impulse,
          "the impulse of the notch at its end that the structure feels, per mass; null if it does "
          "not end at x = 0 or the notch has a width"}};

template <>
inline constexpr auto fields<design::Practice> = [] {
  using Now = design::Practice;
  return std::tuple{
      Field{"secant_stiffness", &Now::secant_stiffness, "at the peak; the spring's is p^2"},
      Field{"equivalent_damping", &Now::equivalent_damping,
            "of a full cycle at that peak; null above 1"},
      Field{"base_shear_over_weight", &Now::base_shear},
      Field{"restoring_over_weight", &Now::restoring},
      Field{"energy_ratio", &Now::energy_ratio, "E_s/E_h (EN 15129)"},
      Field{"residual_ratio", &Now::residual_ratio, "d/d_rm (EN 1998-2)"},
      Field{"impulse_at_stop", &Now::impulse_at_stop, "per mass",
            si_apart(Dimension::impulse, "impulse_at_stop_n_s")},
      Field{"impulse_largest", &Now::impulse_largest, "",
            si_apart(Dimension::impulse, "impulse_largest_n_s")},
      Field{"impulses", &Now::impulses,
            "of each passage and of the stop at x = 0, in turn; at most the last 1000; null in "
            "practice_worst"},
      Field{"notch_capacity", &Now::notch_capacity, "what a whole passage takes"},
      Field{"notch_used", &Now::notch_used, "the share of it that the stop took"},
      Field{"notch_width_min", &Now::notch_width_min,
            "the least width with which the mass feels no more than acceleration_max inside the "
            "notch; null without it, or if there is none"}};
}();

}  // namespace stillpoint

namespace stillpoint::report {

/// All but the first, which is no excitation.
inline constexpr auto excitation_types = std::span(kind_names<Excitation>).subspan<1>();
inline constexpr auto record_units =
    std::to_array<std::string_view>({"g", "m/s2", "cm/s2", "mm/s2"});

/// An excitation: empty is what a type does not have.
struct ShownExcitation {
  std::string_view type;
  std::optional<double> k{}, lambda{}, phase{}, duration{}, pga{};
  std::optional<std::size_t> samples{};
  std::optional<RecordOrigin> record{};

  using Now = ShownExcitation;
  static constexpr auto of_record = [](auto member) { return in(&Now::record, member); };
  static constexpr std::tuple field_table{
      Field{"type", &Now::type, "", one_of(excitation_types)},
      Field{"k", &Now::k, "", any_number},
      Field{"lambda", &Now::lambda},
      Field{"phase", &Now::phase, "", any_number},
      Field{"duration", &Now::duration, "null if it never ends"},
      Field{"record", of_record(&RecordOrigin::file)},
      Field{"samples", &Now::samples},
      Field{"record_units", of_record(&RecordOrigin::units), "", one_of(record_units)},
      Field{"record_step", of_record(&RecordOrigin::step)},
      Field{"record_scale", of_record(&RecordOrigin::scale), "", any_number},
      Field{"record_peak", of_record(&RecordOrigin::peak)},
      Field{"record_spectrum", of_record(&RecordOrigin::spectrum)},
      Field{"record_spectrum_period", of_record(&RecordOrigin::spectrum_period)},
      Field{"record_units_read", of_record(&RecordOrigin::units_read), "of the values in the file",
            one_of(record_units)},
      Field{"record_units_assumed", of_record(&RecordOrigin::assumed),
            "whether neither the file nor an option gives them"},
      Field{"record_factor", of_record(&RecordOrigin::factor), "on the values in the file",
            any_number},
      Field{"pga", &Now::pga, "the largest |W|, with that factor"}};
};
[[nodiscard]] std::optional<ShownExcitation> shown(const Excitation& excitation,
                                                   const std::optional<RecordOrigin>& record);

/// The input of a motion.
struct ShownMotion : SimulationRequest {
  std::optional<RecordOrigin> record;

  using Now = ShownMotion;
  static constexpr std::tuple own_fields{
      Field{"v0", in(&Now::start, &Start::v0), "", any_number},
      Field{"p", in(&Now::oscillator, &Oscillator::p)},
      Field{"f", in(&Now::oscillator, &Oscillator::f)},
      Field{"delta", in(&Now::oscillator, &Oscillator::delta)},
      Field{"x0", in(&Now::start, &Start::x0), "", any_number},
      Field{"t_end", &Now::t_end},
      Field{"excitation", [](const auto& now) { return shown(now.excitation, now.record); },
            "null for what a type does not have"},
      Field{"hold", in(&Now::oscillator, &Oscillator::hold),
            "the load that the notch holds at x = 0 besides f; null: any load"},
      Field{"notch_width", in(&Now::surface, &Surface::notch_width),
            "null: none, the notch acts only at x = 0"},
      Field{"friction_zones",
            only_if([](const auto& now) { return !now.surface.zones.empty(); },
                    in(&Now::surface, &Surface::zones)),
            "friction f for |x| < to, from the zone before it on; beyond the last the motion's own "
            "f",
            at_least_one}};
  static constexpr auto field_table =
      std::tuple_cat(own_fields, fields_in(&Now::oscillator, beyond_the_paper));
};

inline constexpr auto motion_input = [](const auto& report) {
  return ShownMotion{{report.request}, report.record};
};

/// A motion; without a load it has no ForcedResponse.
struct ShownResponse {
  const Response* response;
  const ForcedResponse* forced;
  std::optional<MotionEnergies> energies;  ///< empty of one that was only tried

  explicit ShownResponse(const Response& free, std::optional<MotionEnergies> of = {})
      : response(&free), forced(nullptr), energies(of) {}
  explicit ShownResponse(const ForcedResponse& under_load, std::optional<MotionEnergies> of = {})
      : response(&under_load), forced(&under_load), energies(of) {}

  static constexpr auto field_table = std::tuple_cat(
      fields_in([](const auto& now) -> const Response& { return *now.response; }, fields<Response>),
      fields_in(&ShownResponse::energies, fields<MotionEnergies>),
      fields_in(&ShownResponse::forced, forced_fields));
};

}  // namespace stillpoint::report
