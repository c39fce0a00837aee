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

namespace {

std::string with_blank(const std::string& unit) {
  return unit.empty() ? "" : " " + unit;
}

}  // namespace

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
          what += format(", k = {:.6g}, {}", kind.k, frequency_shown(physical, kind.lambda));
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

Section& add_problem(Document& document, const design::Problem& problem,
                     const design::Limits& limits, const Physical& physical, bool pulsed) {
  Section& section = document.detail("Task");
  if (physical) {
    add_physical_input(section, *physical);
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
  return section;
}

std::string in_words(std::string_view name) {
  if (const std::size_t at = name.find("_max"); at != std::string_view::npos) {
    return format("largest {}", name.substr(0, at));  // delta_max_m is delta_max in metres
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
  return variable == "delta" || variable == "peak" ? std::pair(units.length, units.length_unit)
         : variable == "v0"                        ? std::pair(units.velocity, units.velocity_unit)
         : variable == "acceleration"              ? std::pair(1.0, std::string("g"))
                                                   : std::pair(1.0, std::string());
}

/// "delta <= 8.1577 mm", rounded so that what is as printed meets it.
std::string requirement(const design::Constraint& now, const FigureUnits& units) {
  constexpr int shown = 6;
  constexpr double conversion = 1e-12;  // the rounding of 150 mm to dimensionless and back
  const auto [unit, unit_name] = unit_of(now.variable, units);
  const bool upwards = now.relation.front() == '>';
  if (upwards && now.limit < 0) {
    return format("any {}", now.variable);
  }
  const double limit = now.limit * unit * (upwards ? 1 - conversion : 1 + conversion);
  return format("{} {} {}{}", now.variable, now.relation,
                limit > 0 ? limit_digits(limit, upwards, shown) : digits(limit),
                with_blank(unit_name));
}

/// Of a limit that a damper is compared with.
void add_bound(Section& section, const FigureUnits& units, std::string_view name,
               std::string_view variable, std::string_view relation, double limit,
               std::string_view note = "") {
  const auto bound = design::Constraint::compared(name, variable, relation, 0, limit);
  section.row(in_words(name), format("{}{}", requirement(bound, units), note));
}

}  // namespace

void add_feasible(Section& section, const design::RegionVerdict& verdict,
                  const design::Limits& limits, const Physical& physical) {
  const design::Region& region = verdict.region;
  section.row(physical ? "max displacement" : "beta",
              region.beta_min == 0
                  ? "as small as you like: with f just below the peak load it hardly moves"
                  : format("at least {}{}", length_limit(physical, region.beta_min, true),
                           limits.f_max || limits.delta_max || limits.acceleration_max ||
                                   limits.tolerance > 0
                               ? ", without the limits and the tolerance asked for"
                               : ""));
  const std::string feasible =
      region.feasible ? range_digits(*region.f_lower, *region.f_upper) : "";
  for (const auto& [low, high] : verdict.intervals.value_or(std::vector<Interval>())) {
    if (const std::string all = range_digits(low, high); all != feasible) {
      section.row("admissible f", all);  // without the tolerance, or of other islands
    }
  }
  if (region.feasible) {
    section.row("feasible f",
                feasible + (limits.tolerance > 0 ? ", with the tolerance asked for" : ""));
  }
}

Section& add_region(Document& document, const design::RegionVerdict& verdict,
                    const design::Limits& limits, const Physical& physical) {
  const design::Region& region = verdict.region;
  const bool pulsed = verdict.intervals.has_value();
  const FigureUnits units(physical);
  Section& section = document.detail("Bounds");
  if (!pulsed || region.feasible) {
    add_bound(section, units, "amplitude", "f", ">=", std::max(region.f2, 0.0),
              region.f2 <= 0 ? "  (does not bind)" : "");
  }
  if (pulsed && region.beta_min == 0) {
    section.row("return", "with every f that starts");
  } else {
    add_bound(section, units, "return", "f", "<=", region.f3,
              !pulsed && region.feasible && *region.f_upper > region.f3
                  ? "  (the residual allows more)"
                  : "");
  }
  if (region.f4) {
    add_bound(section, units, "acceleration", "f", "<=", *region.f4,
              *region.f4 < 0 ? "  (no f is small enough)" : "");
  }
  if (region.delta2) {
    add_bound(section, units, "dead_zone", "f", "<", region.f1);
    add_bound(section, units, "start", "delta", "<=", *region.delta2);
  } else {
    section.row("start",
                "f below the peak load; nothing bounds delta, since the mass starts from rest");
  }
  for (const design::LimitKind& kind : design::limit_kinds()) {
    if (const auto& most = limits.*kind.value; most && !kind.figure) {
      add_bound(section, units, kind.constraint, kind.bounds_f() ? "f" : "delta", "<=", *most);
    }
  }
  add_feasible(section, verdict, limits, physical);
  return section;
}

Section& add_constraints(Document& document, std::span<const design::Constraint> constraints,
                         const design::Limits& limits, const Physical& physical) {
  const FigureUnits units(physical);
  const bool all_met = std::ranges::all_of(constraints, &design::Constraint::satisfied);
  const bool returns = std::ranges::none_of(constraints, [](const design::Constraint& now) {
    return now.name == "return" && !now.satisfied;
  });
  Table table{{"", "requirement", "slack", ""}, {}};
  for (const design::Constraint& now : constraints) {
    if (!returns && now.name == "stop") {
      table.rows.push_back({{"stop", "-", "-", "not reached"}});
      continue;
    }
    const auto [unit, unit_name] = unit_of(now.variable, units);
    table.rows.push_back({{in_words(now.name), requirement(now, units),
                           format("{:.4g}{}", now.slack * unit, with_blank(unit_name)),
                           now.satisfied ? "met" : "violated"},
                          now.satisfied ? Tone::good : Tone::bad});
  }
  Section& section = all_met ? document.detail("Constraints") : document.section("Constraints");
  section.parts.emplace_back(std::move(table));
  if (limits.tolerance > 0) {
    section.row("tolerance", "at least " + box_text(limits, limits.tolerance));
  }
  return section;
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
      return "never starts: the hit is too weak to leave the notch";
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

/// The margins of the two motions are different quantities: docs/theory.md section 6,
/// docs/forced.md section 7.
constexpr std::string_view closest_decision =
    "how near the closest decision, to stick or to pass x = 0, was to going the other way; not a "
    "tolerance of the inputs";

}  // namespace

void add_counts(Section& section, const Response& response, const Physical& physical,
                bool margin_of_inputs) {
  if (moves(response) && response.arrival_speed) {
    section.row("arrival speed",
                format("{}, the last at x = 0",
                       FigureUnits(physical).velocity_words(*response.arrival_speed)));
  }
  if (moves(response) && response.half_cycles) {
    section.row("counts", format("{}, {}, {}", plural(response.half_cycles, "half-cycle"),
                                 plural(response.zero_passages, "passage"),
                                 plural(response.turning_points, "turning point")));
  }
  if (response.decision_margin) {
    section.row("decision margin",
                format("{:.2g} %: {}", 100 * *response.decision_margin,
                       !margin_of_inputs ? closest_decision
                       : response.outcome == Outcome::caught_at_start
                           ? "it may start if all inputs shift by about this much"
                           : "it may stop elsewhere if all inputs shift by about this much; a "
                             "limit may be exceeded long before"));
  }
}

void add_response(Section& section, const Simulation& answer, const Physical& physical,
                  bool margin_of_inputs) {
  const Response& response = answer.response;
  const auto& forced = answer.forced;
  const bool held = !moves(response) && response.outcome != Outcome::caught_at_start;
  section.row("outcome", held     ? "never moves"
                         : forced ? outcome_phrase(*forced)
                                  : outcome_phrase(response.outcome));
  if (forced) {
    const bool impulses = std::ranges::any_of(
        answer.half_cycles, [](const HalfCycle& now) { return now.impulse.value_or(0) > 0; });
    section.row("transmitted",
                format("{:.6g} g, the largest acceleration that the structure feels{}",
                       response.peak_absolute_acceleration, impulses ? ", impulses apart" : ""));
  }
  if (moves(response)) {
    section.row("peak", length_shown(physical, response.peak_amplitude));
    section.row(forced ? "relative" : "peak acceleration",
                format("{:.6g} g{}", response.peak_acceleration,
                       forced ? ", the largest acceleration relative to the base" : ""));
    if (response.stop_time) {
      section.row("stop time", time_shown(physical, *response.stop_time));
      section.row("stop position", length_shown(physical, *response.stop_position));
    }
  }
  add_counts(section, response, physical, margin_of_inputs && !forced);
  if (!forced) {
    return;
  }
  if (forced->sticks > 0) {
    section.row("sticks", format("{}, {} in all", plural(forced->sticks, "stick"),
                                 time_shown(physical, forced->stick_time)));
  }
  if (forced->end_time && forced->outcome == Outcome::running) {
    section.row("at the end",
                format("{}, x = {}, v = {}", time_shown(physical, *forced->end_time),
                       length_shown(physical, *forced->final_position),
                       FigureUnits(physical).velocity_words(*forced->final_velocity)));
  }
  if (forced->left_notch_from_rest) {
    section.row("note",
                "it started from rest at x = 0, so the notch acts from the first return on");
  }
}

}  // namespace stillpoint::report
