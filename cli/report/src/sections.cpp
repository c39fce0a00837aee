// SPDX-License-Identifier: MIT
#include "sections.hpp"
#include "format.hpp"

#include <stillpoint/records/record_scaling.hpp>
#include <stillpoint/report/digits.hpp>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <optional>
#include <utility>
#include <variant>

namespace stillpoint::report {

void add_physical_input(Section& section, const design::PhysicalInput& physical, double stiffest) {
  const design::Scales& scales = physical.scales;
  const auto to_stiffest = [stiffest](double value, double factor, std::string_view unit) {
    return stiffest == 1
               ? with_unit(value, unit)
               : format("{} to {}", with_unit(value, unit), with_unit(value * factor, unit));
  };
  std::string isolator = format("period {}", to_stiffest(physical.period_s, 1 / stiffest, "s"));
  if (physical.by_frequency) {
    isolator += format(
        " ({})", to_stiffest(scales.omega_rad_per_s / (2 * std::numbers::pi), stiffest, "Hz"));
  }
  if (scales.mass_kg) {
    const bool heavy = *scales.mass_kg >= 1e3;
    isolator += format(", mass {:.6g} {}, stiffness {}", *scales.mass_kg * (heavy ? 1e-3 : 1),
                       heavy ? "t" : "kg",
                       to_stiffest(*scales.stiffness_n_per_m(), stiffest * stiffest, "N/m"));
  }
  section.row("isolator", isolator);
  if (physical.velocity_m_per_s != 0) {  // a pulse moves the mass from rest
    section.row("velocity", format("{:.6g} m/s", physical.velocity_m_per_s));
  }
  if (physical.max_displacement_m) {
    section.row("max displacement", with_unit(*physical.max_displacement_m, "m"));
  }
  section.row("units",
              format("length H = {}, time {}, gravity {:.6g} m/s2", with_unit(scales.length_m, "m"),
                     with_unit(scales.time_s, "s"), scales.gravity_m_per_s2));
}

std::string damper_words(const Physical& physical, const std::optional<double>& f, double delta,
                         const design::NotchShape& shape, std::optional<int> digits) {
  const auto scales = physical ? std::optional(physical->scales) : std::nullopt;
  const auto force = scales ? scales->friction_force_n(f.value_or(0)) : std::nullopt;
  const auto energy = scales ? scales->energy_per_passage_j(delta) : std::nullopt;
  const bool weighed = force && energy && std::isfinite(*energy);
  const std::string which =
      shape.width ? format("a notch {} wide", length_shown(physical, *shape.width))
      : shape.hold
          ? format("a notch that lets go at {} above the friction", acceleration_shown(*shape.hold))
          : "a notch";
  const std::string notch =
      weighed ? format("{} {} takes {} at a passage", which, shape.hold ? "and" : "that",
                       with_unit(*energy, "J"))
              : format("delta = {}{}", length_shown(physical, delta, digits),
                       delta > 0 && (shape.width || shape.hold) ? " in " + which : "");
  const std::string friction = !f        ? ""
                               : weighed ? "a friction force of " + with_unit(*force, "N")
                               : digits  ? format("f = {:.{}g}", *f, *digits)
                                         : format("f = {}", *f);
  return !f           ? notch + " and as little constant friction as you can"
         : delta == 0 ? *f == 0 ? "neither friction nor a notch" : friction + " without a notch"
         : weighed && *f == 0 ? notch + ", without constant friction"
                              : friction + " and " + notch;
}

std::string period_words(const Physical& physical, double p, std::optional<int> digits) {
  return physical ? format("a period of {:.{}g} s",
                           2 * std::numbers::pi / p * physical->scales.time_s, digits.value_or(4))
                  : format("p = {:.{}g}", p, digits.value_or(6));
}

std::string spring_words(const Physical& physical, double p, std::optional<int> digits) {
  std::optional<double> stiffness;
  if (physical) {
    design::Scales scales = physical->scales;
    scales.omega_rad_per_s = p / scales.time_s;
    stiffness = scales.stiffness_n_per_m();
  }
  return period_words(physical, p, digits) +
         (stiffness ? format(" (stiffness {})", with_unit(*stiffness, "N/m")) : "");
}

std::string_view jumps_words(double delta, const std::optional<double>& width) {
  return delta > 0 && !width ? " between the velocity jumps at the notch" : "";
}

void add_zones(Section& section, const std::vector<FrictionZone>& zones, std::string_view beyond,
               const Physical& physical) {
  std::optional<double> from;
  for (const FrictionZone& zone : zones) {
    const std::string to = length_shown(physical, zone.to);
    section.row(from ? "" : "friction", from ? format("{:.6g} for |x| from {} to {}", zone.f,
                                                      length_shown(physical, *from), to)
                                             : format("{:.6g} for |x| < {}", zone.f, to));
    from = zone.to;
  }
  if (from) {
    section.row("", format("{} beyond", beyond));
  }
}

void add_surface(Section& section, const SimulationRequest& request, const Physical& physical) {
  const auto& [p, f, delta, hold] = request.oscillator;
  const Surface& surface = request.surface;
  if (hold) {
    const double friction = design::friction_at_centre(request);
    section.row("notch", format("holds a load of up to {} + {:.6g} g = {:.6g} g",
                                surface.zones.empty() ? "f" : format("{:.6g} g", friction), *hold,
                                friction + *hold));
  }
  if (surface.notch_width) {
    const double wall = delta / *surface.notch_width;
    const std::string half = length_shown(physical, *surface.notch_width / 2);
    section.row("notch", surface.zones.empty()
                             ? format("friction {:.6g} for |x| < {}", f + wall, half)
                             : format("adds {:.6g} to the friction for |x| < {}", wall, half));
  }
  add_zones(section, surface.zones, format("f = {:.6g}", f), physical);
}

void add_excitation(Section& section, const Excitation& excitation,
                    const std::optional<RecordOrigin>& record, const Physical& physical) {
  std::string what(name(excitation));
  std::visit(
      [&]<class Kind>(const Kind& kind) {
        if constexpr (requires { kind.lambda; }) {
          what += format(", k = {:.6g} g, {}", kind.k, frequency_shown(physical, kind.lambda));
        } else if constexpr (requires { kind.values; }) {
          const auto [least, most] = std::ranges::minmax(kind.values);
          what += format(", {} values from {:.6g} g to {:.6g} g", kind.values.size(), least + 0.0,
                         most + 0.0);  // no -0
        }
        if constexpr (IsSine<Kind> && !IsPulse<Kind>) {
          what += format(", phase {:.6g}", kind.phase);
        }
      },
      excitation);
  section.row("excitation", what);
  if (record) {
    section.row("record", spelled_out(record->file));
    if (!record->description.empty()) {
      section.row("", spelled_out(record->description));
    }
    std::string values =
        "values in " + record->units_read + (record->assumed ? ", which is assumed" : "");
    if (record->factor != 1) {
      values += format(", times {:.6g}; the peak is then {:.6g} g", record->factor,
                       records::peak_acceleration(std::get<Record>(excitation)));
    }
    section.row("", values);
  }
  if (const auto lasts = duration(excitation)) {
    section.row("duration", time_shown(physical, *lasts));
  }
}

std::string range_words(const design::Problem& problem, const Physical& physical) {
  const FigureUnits units(physical);
  std::string words;
  if (problem.v0_low) {
    const std::string most =
        format("{:.6g}{}", problem.v0 * units.velocity, with_blank(units.velocity_unit));
    words = *problem.v0_low == 0
                ? "hits up to " + most
                : format("hits of {:.6g} to {}", *problem.v0_low * units.velocity, most);
  }
  if (problem.p_high) {
    const double period = 2 * std::numbers::pi * units.time;
    words += words.empty() ? "" : " and ";
    words += physical ? format("periods of {:.6g} to {:.6g} s", period / *problem.p_high,
                               period / problem.p)
                      : format("springs with p of {:.6g} to {:.6g}", problem.p, *problem.p_high);
  }
  return words;
}

std::string extreme_words(const design::Problem& problem, std::string_view spring) {
  return format("{}{}{}", problem.v0_low ? "strongest hit" : "",
                problem.v0_low && problem.p_high ? ", " : "",
                problem.p_high ? format("{} spring", spring) : "");
}

std::string shown_words(const ShownTask& task) {
  const auto& [problem, limits, pulse, ranges, physical] = task;
  return !pulse ? extreme_words(problem, "softest")
         : design::pulse_problem(problem, *pulse, ranges).has_ranges() ? "largest peak"
                                                                       : "";
}

void add_limits(Section& section, const design::Limits& limits, const Physical& physical) {
  std::string limit;
  const auto add = [&](const std::string& text) { limit += (limit.empty() ? "" : ", ") + text; };
  for (const design::LimitKind& kind : design::limit_kinds()) {
    if (const auto& most = limits.*kind.value) {
      add(format(
          "{} <= {}", kind.quantity,
          kind.bounds_f() ? format("{:.6g}{}", *most, kind.unit) : length_shown(physical, *most)));
    }
  }
  if (limits.tolerance > 0) {
    add("tolerance " + box_text(limits, limits.tolerance));
  }
  if (!limit.empty()) {
    section.row("limits", limit);
  }
}

Section& add_problem(Document& document, const design::Problem& problem,
                     const design::Limits& limits, const Physical& physical, bool pulsed) {
  Section& section = document.detail("Task");
  if (physical) {
    design::PhysicalInput shown = *physical;
    if (problem.v0_low) {  // which the ranges say
      shown.velocity_m_per_s = 0;
    }
    add_physical_input(section, shown, problem.stiffest_p() / problem.p);
  }
  section.row("dimensionless",
              format("{}p = {:.6g}, beta = {:.6g}",
                     pulsed ? "" : format("v0 = {:.6g}, ", problem.v0), problem.p, problem.beta));
  if (const std::string ranges = range_words(problem, physical); !ranges.empty()) {
    section.row("ranges", "all " + ranges);
  }
  if (problem.residual) {
    section.row("residual", format("a rest within {} is admissible",
                                   length_shown(physical, *problem.residual)));
  }
  section.row("criterion", format("{} Delta1", name(problem.criterion)));
  if (problem.arrivals > 1) {
    section.row("arrivals", format("stop at x = 0 by arrival {}", problem.arrivals));
  }
  add_limits(section, limits, physical);
  return section;
}

}  // namespace stillpoint::report
