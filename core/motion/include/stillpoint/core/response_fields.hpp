// SPDX-License-Identifier: MIT
#pragma once

// The figures of a motion: a row each.

#include <stillpoint/core/field.hpp>
#include <stillpoint/core/forced_motion.hpp>
#include <stillpoint/core/free_motion.hpp>
#include <stillpoint/core/motion_energies.hpp>

#include <string_view>
#include <tuple>

namespace stillpoint {

/// Of the largest acceleration that the structure feels, in every report.
inline constexpr std::string_view transmitted_name = "peak_absolute_acceleration";

template <>
inline constexpr auto fields<Response> = std::tuple{
    Field{"peak_amplitude", &Response::peak_amplitude, "largest |x|",
          si_apart(Dimension::length, "peak_m")},
    Field{
        "peak_acceleration", &Response::peak_acceleration,
        "largest |x''| relative to the base, inside a notch with a width too; not the jumps at one "
        "without",
        si_apart(Dimension::gravities, "peak_acceleration_m_per_s2")},
    Field{transmitted_name, &Response::peak_absolute_acceleration,
          "the largest acceleration that the structure feels, in g: friction and restoring force "
          "while the mass slides, |W| while it is held, over the whole load; not the jumps at a "
          "notch without width (forced.md section 10). Without a load equal to peak_acceleration. "
          "It is what the objective acceleration minimises",
          si_apart(Dimension::gravities, "peak_absolute_acceleration_m_per_s2")},
    Field{"jump", &Response::jump,
          "the largest jump of velocity at a notch without width, |v-| - |v+| of a passage, |v-| "
          "of a stop and |v0| of a start that the notch catches; 0 without such a notch. The "
          "acceleration leaves it out",
          si_apart(Dimension::velocity, "jump_m_per_s")},
    Field{"half_cycles", &Response::half_cycles,
          "1 + zero_passages, or 0 where nothing moves; null if the motion never stops, like the "
          "next two",
          counted},
    Field{"turning_points", &Response::turning_points,
          "times when a moving mass reaches x' = 0 at x != 0, including a final rest", counted},
    Field{"zero_passages", &Response::zero_passages,
          "arrivals at x = 0 after which the motion goes on", counted},
    Field{"stop_time", &Response::stop_time, "null where the motion never stops or is running",
          si_apart(Dimension::time, "stop_time_s")},
    Field{"stop_position", &Response::stop_position, "null like stop_time",
          si_apart(Dimension::length, "stop_position_m", Numbers::all)},
    Field{"stops_at_zero", &Response::stops_at_zero, "whether it stops at x = 0"},
    Field{"outcome", &Response::outcome,
          "stopped_in_notch (|x| up to w/2, x not 0) only in a notch with a width; running: the "
          "run ended before the motion stopped for good, even if friction or the notch held the "
          "mass (then final_velocity is 0; if it was the notch, locked_from says since when)"},
    Field{"arrival_speed", &Response::arrival_speed,
          "at the last arrival at x = 0, before the notch acts; null where there was none",
          si_apart(Dimension::velocity, "arrival_speed_m_per_s")},
    Field{"decision_margin", &Response::decision_margin,
          "how close a decision came to the other outcome (theory.md section 6, forced.md section "
          "7); null where nothing was decided"}};

/// What a motion under a load has besides.
inline constexpr auto forced_fields = std::tuple{
    Field{"end_time", &ForcedResponse::end_time,
          "of the run; null if it has no end, like the next two",
          si_apart(Dimension::time, "end_time_s")},
    Field{"final_position", &ForcedResponse::final_position, "there",
          si_apart(Dimension::length, "final_position_m", Numbers::all)},
    Field{"final_velocity", &ForcedResponse::final_velocity, "there",
          si_apart(Dimension::velocity, "final_velocity_m_per_s", Numbers::all)},
    Field{"sticks", &ForcedResponse::sticks,
          "how often friction holds the mass for a while, the final rest not included", counted},
    Field{"stick_time", &ForcedResponse::stick_time, "for how long, in all",
          si_apart(Dimension::time, "stick_time_s")},
    Field{"left_notch_from_rest", &ForcedResponse::left_notch_from_rest,
          "whether the mass left rest at x = 0 although delta > 0: the notch acts from the first "
          "return on"},
    Field{
        "locked_from", &ForcedResponse::locked_from,
        "the tau from which the notch holds the mass at x = 0, or within its width, although the "
        "load goes on (0 where the mass is caught at the start). null where the mass does not "
        "lock. A stop after the load is over is not a lock, nor is a rest in the dead zone, where "
        "friction holds the mass",
        si_apart(Dimension::time, "locked_from_s")},
    Field{"largest_load_while_locked", &ForcedResponse::largest_load_while_locked,
          "the largest |W| from there, in g, which the structure then feels; null where the mass "
          "does not lock",
          si_apart(Dimension::gravities, "largest_load_while_locked_m_per_s2")}};

/// Where the energy goes: of the motions that reports show.
template <>
inline constexpr auto fields<MotionEnergies> = [] {
  const auto part = [](auto member) { return in(&MotionEnergies::energies, member); };
  return std::tuple{
      Field{"peak_velocity", &MotionEnergies::peak_velocity,
            "largest |x'| relative to the base, the start included",
            si_apart(Dimension::velocity, "peak_velocity_m_per_s")},
      Field{"slip_path", part(&Energies::slip_path),
            "the distance slid up to the end; null if the motion has no end, like the next four",
            si_apart(Dimension::length, "slip_path_m")},
      Field{"friction_energy", part(&Energies::friction),
            "what constant friction took, f times the slip path, per mass (forced.md section 11)",
            si_apart(Dimension::energy, "friction_energy_j")},
      Field{"notch_energy", part(&Energies::notch),
            "what the notch took, of a stop and of a caught start as well",
            si_apart(Dimension::energy, "notch_energy_j")},
      Field{"damping_energy", part(&Energies::damping), "what damping took",
            si_apart(Dimension::energy, "damping_energy_j")},
      Field{"load_energy", part(&Energies::load),
            "what the load gave, its work on the mass as seen from the base; the four and the "
            "energy left at the end balance that of the start",
            si_apart(Dimension::energy, "load_energy_j", Numbers::all)}};
}();

template <>
inline constexpr auto fields<ForcedResponse> = std::tuple_cat(fields<Response>, forced_fields);

}  // namespace stillpoint
