// SPDX-License-Identifier: MIT
#include "sections.hpp"
#include "format.hpp"

#include <stillpoint/records/record_scaling.hpp>
#include <stillpoint/report/digits.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <optional>
#include <utility>
#include <variant>

namespace stillpoint::report {

void add_physical_input(Section& section, const design::PhysicalInput& physical) {
  const design::Scales& scales = physical.scales;
  std::string isolator = format("period {}", with_unit(physical.period_s, "s"));
  if (physical.by_frequency) {
    isolator += format(" ({:.5g} Hz)", scales.omega_rad_per_s / (2 * std::numbers::pi));
  }
  if (scales.mass_kg) {
    const bool heavy = *scales.mass_kg >= 1e3;
    isolator += format(", mass {:.6g} {}, stiffness {}", *scales.mass_kg * (heavy ? 1e-3 : 1),
                       heavy ? "t" : "kg", with_unit(*scales.stiffness_n_per_m(), "N/m"));
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
                         const std::optional<double>& notch_width) {
  const auto scales = physical ? std::optional(physical->scales) : std::nullopt;
  const auto force = scales ? scales->friction_force_n(f.value_or(0)) : std::nullopt;
  const auto energy = scales ? scales->energy_per_passage_j(delta) : std::nullopt;
  const bool weighed = force && energy && std::isfinite(*energy);
  const std::string wide =
      notch_width ? format(" {} wide", length_shown(physical, *notch_width)) : "";
  const std::string notch =
      weighed && delta == 0 ? "no notch"
      : weighed ? format("a notch{} that takes {} at a passage", wide, with_unit(*energy, "J"))
                : format("delta = {}{}{}", length_shown(physical, delta),
                         wide.empty() ? "" : " in a notch", wide);
  return !f        ? notch + " and as little constant friction as you can"
         : weighed ? format("a friction force of {} and {}", with_unit(*force, "N"), notch)
                   : format("f = {} and {}", digits(*f), notch);
}

std::string spring_words(const Physical& physical, double p) {
  if (!physical) {
    return format("p = {:.6g}", p);
  }
  design::Scales scales = physical->scales;
  scales.omega_rad_per_s = p / scales.time_s;
  const auto stiffness = scales.stiffness_n_per_m();
  return format("a period of {:.4g} s{}", 2 * std::numbers::pi / scales.omega_rad_per_s,
                stiffness ? format(" (stiffness {})", with_unit(*stiffness, "N/m")) : "");
}

void add_damper_physics(Section& section, const Physical& physical, double f, double delta) {
  if (!physical) {
    return;
  }
  if (const auto force = physical->scales.friction_force_n(f)) {
    section.row("friction force", with_unit(*force, "N"));
  }
  if (const auto energy = physical->scales.energy_per_passage_j(delta);
      energy && delta > 0 && std::isfinite(*energy)) {
    section.row("notch capacity", with_unit(*energy, "J") + " for a whole passage");
  }
}

void add_surface(Section& section, const SimulationRequest& request, const Physical& physical) {
  const auto& [p, f, delta, hold] = request.oscillator;
  const Surface& surface = request.surface;
  if (hold) {
    section.row("notch", format("holds a load of up to f + {:.6g} g = {:.6g} g", *hold, f + *hold));
  }
  if (surface.notch_width) {
    const double half = *surface.notch_width / 2;
    section.row("notch", format("friction {:.6g} for |x| < {}", f + delta / *surface.notch_width,
                                length_shown(physical, half)));
  }
  std::optional<double> from;
  for (const FrictionZone& zone : surface.zones) {
    const std::string to = length_shown(physical, zone.to);
    section.row(from ? "" : "friction", from ? format("{:.6g} for |x| from {} to {}", zone.f,
                                                      length_shown(physical, *from), to)
                                             : format("{:.6g} for |x| < {}", zone.f, to));
    from = zone.to;
  }
  if (from) {
    section.row("", format("f = {:.6g} beyond", f));
  }
}

void add_excitation(Section& section, const Excitation& excitation,
                    const std::optional<RecordOrigin>& record, const Physical& physical) {
  std::string what(name(excitation));
  std::visit(
      [&]<class Kind>(const Kind& kind) {
        if constexpr (requires { kind.lambda; }) {
          what +=
              format(", k = {:.6g}, lambda = {}", kind.k, frequency_text(physical, kind.lambda));
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
    std::string values = "values in " + record->units_read;
    if (record->factor != 1) {
      values += format(", times {:.6g}; the peak is then {:.6g} g", record->factor,
                       records::peak_acceleration(std::get<Record>(excitation)));
    }
    section.row("", values);
  }
  if (const auto lasts = duration(excitation)) {
    section.row("duration", time_text(physical, *lasts));
  }
}

Section& add_problem(Document& document, const design::Problem& problem,
                     const design::Limits& limits, const Physical& physical, bool pulsed) {
  Section& section = document.detail("Task");
  if (physical) {
    add_physical_input(section, *physical);
  }
  section.row("dimensionless",
              format("{}p = {:.6g}, beta = {:.6g}",
                     pulsed ? "" : format("v0 = {:.6g}, ", problem.v0), problem.p, problem.beta));
  const double velocity = physical ? physical->scales.velocity_m_per_s : 1;
  if (problem.v0_low) {
    const std::string low =
        *problem.v0_low > 0 ? format(" from {:.6g}", *problem.v0_low * velocity) : "";
    section.row("hits", format("all{} up to {:.6g}{}; the motion shown is for the strongest", low,
                               problem.v0 * velocity, physical ? " m/s" : ""));
  }
  if (problem.p_high) {
    const double period = physical ? 2 * std::numbers::pi * physical->scales.time_s : 0;
    section.row("springs",
                format("{} {:.6g} to {:.6g}{}{}", physical ? "periods of" : "p",
                       physical ? period / *problem.p_high : problem.p,
                       physical ? period / problem.p : *problem.p_high, physical ? " s" : "",
                       pulsed ? "" : "; the motion shown is for the softest"));
  }
  if (problem.residual) {
    section.row("residual",
                format("a rest within {} is admissible", length_text(physical, *problem.residual)));
  }
  section.row("criterion", format("{} Delta1", name(problem.criterion)));
  if (problem.arrivals > 1) {
    section.row("arrivals", format("stop at x = 0 by arrival {}", problem.arrivals));
  }
  std::string limit;
  const auto add = [&](const std::string& text) { limit += (limit.empty() ? "" : ", ") + text; };
  for (const design::LimitKind& kind : design::limit_kinds()) {
    if (const auto& most = limits.*kind.value) {
      add(format(
          "{} <= {}", kind.quantity,
          kind.bounds_f() ? format("{:.6g}{}", *most, kind.unit) : length_text(physical, *most)));
    }
  }
  if (limits.tolerance > 0) {
    add("tolerance " + box_text(limits, limits.tolerance));
  }
  if (!limit.empty()) {
    section.row("limits", limit);
  }
  return section;
}

Section& add_region(Document& document, const design::Region& region, const Physical& physical) {
  Section& section = document.detail("Bounds");
  section.row("amplitude",
              format("f >= f2 = {:.6g}{}", region.f2, region.f2 <= 0 ? "  (does not bind)" : ""));
  section.row(
      "return",
      format("f <= f3 = {:.6g}{}", region.f3,
             region.feasible && *region.f_upper > region.f3 ? "  (the residual allows more)" : ""));
  if (region.f4) {
    section.row("acceleration", format("f <= f4 = {:.6g}{}", *region.f4,
                                       *region.f4 < 0 ? "  (no f is small enough)" : ""));
  }
  section.row("dead zone", format("f < f1 = {:.6g}", region.f1));
  section.row("start",
              format("delta <= delta2 = {}", length_text(physical, region.delta2.value())));
  section.row("smallest beta", length_text(physical, region.beta_min));
  if (region.feasible) {
    section.row("feasible f", range_digits(*region.f_lower, *region.f_upper));
  }
  return section;
}

std::string in_words(std::string_view name) {
  constexpr auto words = std::to_array<std::pair<std::string_view, std::string_view>>(
      {{"f_max", "largest f"},
       {"delta_max", "largest delta"},
       {"delta_max_m", "largest delta"},
       {"acceleration_max", "largest acceleration"}});
  for (const auto& [field, phrase] : words) {
    if (field == name) {
      return std::string(phrase);
    }
  }
  std::string text(name);
  std::ranges::replace(text, '_', ' ');
  return text;
}

bool stops_by_delta1(std::span<const design::Constraint> constraints) {
  return std::ranges::any_of(constraints, [](const design::Constraint& now) {
    return now.name == "stop" && now.variable == "delta";
  });
}

namespace {

std::pair<double, std::string> unit_of(std::string_view variable, const FigureUnits& units) {
  if (variable == "delta" || variable == "peak") {
    return {units.length, units.length_unit};
  }
  if (variable == "v0") {
    return {units.velocity, units.velocity_unit};
  }
  return {1, variable == "acceleration" ? "g" : ""};
}

}  // namespace

void add_constraints(Document& document, std::span<const design::Constraint> constraints,
                     const Physical& physical) {
  const FigureUnits units(physical);
  const bool all_met = std::ranges::all_of(constraints, &design::Constraint::satisfied);
  const bool returns = std::ranges::none_of(constraints, [](const design::Constraint& now) {
    return now.name == "return" && !now.satisfied;
  });
  Table table{{"", "", "value", "", "limit", "slack", ""}, {}};
  for (const design::Constraint& now : constraints) {
    const auto [unit, unit_name] = unit_of(now.variable, units);
    const bool reached = returns || now.name != "stop";
    table.rows.push_back(
        {{in_words(now.name), in(std::string(now.variable), unit_name), digits(now.value * unit),
          std::string(now.relation), digits(now.limit * unit), digits(now.slack * unit),
          !reached        ? "not reached"
          : now.satisfied ? "met"
                          : "violated"},
         !reached        ? Tone::plain
         : now.satisfied ? Tone::good
                         : Tone::bad});
  }
  Section& section = all_met ? document.detail("Constraints") : document.section("Constraints");
  section.parts.emplace_back(std::move(table));
}

bool moves(const Response& response) {
  return response.stop_time != 0.0;
}

std::string outcome_phrase(Outcome outcome) {
  switch (outcome) {
    case Outcome::stopped_at_zero:
      return "stops at x = 0";
    case Outcome::stopped_in_dead_zone:
      return "stops off x = 0, in the dead zone";
    case Outcome::stopped_in_notch:
      return "stops off x = 0, in the notch";
    case Outcome::never_stops:
      return "never stops: there is no friction";
    case Outcome::caught_at_start:
      return "never starts: the hit is too weak to leave the notch (v0^2 < 2 delta)";
    case Outcome::running:
      return "is still moving at the end of the run";
  }
  return {};
}

std::string outcome_phrase(const ForcedResponse& response) {
  return response.outcome == Outcome::running && response.final_velocity == 0
             ? "is at rest at the end of the run"
             : outcome_phrase(response.outcome);
}

namespace {

/// "0.104242 = 0.4556 m/s".
std::string velocity_text(const Physical& physical, double velocity) {
  return digits(velocity) +
         (physical ? " = " + FigureUnits(physical).velocity_words(velocity) : "");
}

std::string acceleration_text(const Physical& physical, double acceleration) {
  return physical ? format("{:.6g} g = {:.5g} m/s2", acceleration,
                           acceleration * physical->scales.gravity_m_per_s2)
                  : format("{:.6g} g", acceleration);
}

void add_outcome(Section& section, const Response& response, const std::string& ends,
                 const Physical& physical) {
  const bool held = !moves(response) && response.outcome != Outcome::caught_at_start;
  section.row("outcome", held ? "never moves" : ends);
  if (moves(response)) {
    section.row("peak", length_text(physical, response.peak_amplitude));
  }
}

void add_metrics(Section& section, const Response& response, const Physical& physical) {
  if (!moves(response)) {
    return;
  }
  if (response.stop_time) {
    section.row("stop time", time_text(physical, *response.stop_time));
    section.row("stop position", length_text(physical, *response.stop_position));
  }
  if (response.arrival_speed) {
    section.row("arrival speed",
                velocity_text(physical, *response.arrival_speed) + ", the last at x = 0");
  }
  if (response.half_cycles) {
    section.row("counts", format("{}, {}, {}", plural(response.half_cycles, "half-cycle"),
                                 plural(response.zero_passages, "passage"),
                                 plural(response.turning_points, "turning point")));
  }
}

/// The margins of the two motions are different quantities: docs/theory.md section 6,
/// docs/forced.md section 7.
void add_margin(Section& section, const Response& response, std::string_view meaning) {
  if (response.decision_margin) {
    section.row("decision margin",
                format("{:.2g} %: {}", 100 * *response.decision_margin, meaning));
  }
}

constexpr std::string_view closest_decision =
    "how near the closest decision, to stick or to pass x = 0, was to going the other way; not a "
    "tolerance of the inputs";

}  // namespace

void add_response(Section& section, const Response& response, const Physical& physical,
                  bool margin_of_inputs) {
  add_outcome(section, response, outcome_phrase(response.outcome), physical);
  if (moves(response)) {
    section.row("peak acceleration", acceleration_text(physical, response.peak_acceleration));
  }
  add_metrics(section, response, physical);
  add_margin(section, response,
             margin_of_inputs
                 ? "the outcome or a count could change if all inputs shift by about this much"
                 : closest_decision);
}

void add_response(Section& section, const ForcedResponse& response, const Physical& physical) {
  add_outcome(section, response, outcome_phrase(response), physical);
  section.row("transmitted",
              format("{}, the largest acceleration that the structure feels, impulses apart",
                     acceleration_text(physical, response.peak_absolute_acceleration)));
  if (moves(response)) {
    section.row("relative", format("{}, the largest acceleration relative to the base",
                                   acceleration_text(physical, response.peak_acceleration)));
  }
  add_metrics(section, response, physical);
  add_margin(section, response, closest_decision);
  if (response.sticks > 0) {
    section.row("sticks", format("{}, {} in all", plural(response.sticks, "stick"),
                                 time_shown(physical, response.stick_time)));
  }
  if (response.end_time && response.outcome == Outcome::running) {
    section.row("at the end",
                format("tau = {}, x = {}, v = {}", time_text(physical, *response.end_time),
                       length_text(physical, *response.final_position),
                       velocity_text(physical, *response.final_velocity)));
  }
  if (response.left_notch_from_rest) {
    section.row("note",
                "it started from rest at x = 0, so the notch acts from the first return on");
  }
}

}  // namespace stillpoint::report
