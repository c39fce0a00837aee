// SPDX-License-Identifier: MIT
#include "sections.hpp"

#include <stillpoint/report/findings.hpp>

#include <fmt/ranges.h>

#include <array>
#include <bit>
#include <iterator>

namespace stillpoint::report {

namespace {

/// Where the largest transmitted acceleration is felt, if there is a notch.
std::string_view felt_where(const MotionReport& report, double felt) {
  const Oscillator& damper = report.request.oscillator;
  const Response& response = report.answer.response;
  const auto& forced = report.answer.forced;
  return forced && forced->largest_load_while_locked == felt ? " while it is locked"
         : damper.delta == 0 || response.peak_amplitude == 0 ? ""
         : forced && response.jump > 0                       ? " between the jumps"
         : damper.hold || report.request.surface.notch_width ? ", the notch included"
                                                             : ", outside the notch";
}

void add_answer(Section& answer, const MotionReport& report) {
  const double f = report.request.oscillator.f;
  const double delta = report.request.oscillator.delta;
  const std::optional<double>& hold = report.request.oscillator.hold;
  const auto& [notch_width, zones] = report.request.surface;
  const Response& response = report.answer.response;
  const Physical& physical = report.physical;
  constexpr int digits = 6;
  answer.row("damper", damper_words(physical, f, delta, {notch_width, hold}, digits) +
                           (zones.empty() ? ""
                                          : ", with other friction up to x = " +
                                                length_shown(physical, zones.back().to)));
  add_damping(answer, report.request.oscillator);
  if (report.record) {
    answer.row("record",
               record_words(report.record->file, report.record->factor, report.record->units_read,
                            report.record->assumed, design::peak_load(report.request.excitation)));
  }
  if (moves(response)) {
    answer.row("peak", length_shown(physical, response.peak_amplitude), Tone::heading);
  }
  if (report.answer.forced || moves(response)) {
    const double felt = design::figures_of(response).acceleration;
    answer.row("acceleration",
               format("{} transmitted{}", acceleration_shown(felt), felt_where(report, felt)));
  }
  if (const auto& energies = report.answer.energies.energies; energies && energies->friction > 0) {
    const auto joules =
        physical ? physical->scales.energy_per_passage_j(energies->friction) : std::nullopt;
    answer.row("energy", format("friction takes {} over a path of {}",
                                joules ? si_words(physical, *joules, "J", usual_digits)
                                       : units_of(physical).energy.words(energies->friction),
                                length_shown(physical, energies->slip_path)));
  }
  if (report.answer.forced && report.answer.forced->left_notch_from_rest) {
    const double load = design::peak_load(report.request.excitation);
    add_start(answer, design::least_width(design::holding_friction(report.request), delta, load),
              response, physical);
  }
  if (report.answer.forced && response.outcome == Outcome::running) {
    const ForcedResponse& forced = *report.answer.forced;
    answer.row("at the end", format("x = {} at {}", length_shown(physical, *forced.final_position),
                                    time_shown(physical, *forced.end_time)));
  }
}

/// The first of `count` as a table.
void add_half_cycles(Section& section, std::span<const HalfCycle> half_cycles,
                     const std::optional<double>& count, const Physical& physical) {
  constexpr std::size_t most_half_cycles = 12;
  const FigureUnits units = units_of(physical);
  Table table{{"", in("starts", units.time), in("leaves with", units.velocity),
               in("peak at", units.time), in("peak", units.length), in("ends", units.time),
               in("arrives with", units.velocity), in("impulse/mass", units.velocity)},
              {}};
  const std::size_t listed = std::min(most_half_cycles, half_cycles.size());
  for (const HalfCycle& now : half_cycles.first(listed)) {
    table.rows.push_back(
        {{format("{}", now.index), digits(now.start_time * units.time),
          digits(now.departure_speed * units.velocity), digits(now.peak_time * units.time),
          digits(now.side * now.peak * units.length), digits(now.end_time * units.time),
          now.arrival_speed ? digits(*now.arrival_speed * units.velocity) : "none",
          now.impulse.value_or(0) > 0 ? digits(*now.impulse * units.velocity) : ""}});
  }
  section.parts.emplace_back(without_empty_columns(std::move(table)));
  if (count.value_or(HUGE_VAL) > static_cast<double>(listed)) {
    section.line(format("The first {}{}; --json lists more, see --max-half-cycles.", listed,
                        count ? " of " + plural(count, "half-cycle") : ""),
                 Tone::faint);
  }
}

/// A member of TracedState, and its name in SI units: an acceleration of g, and friction, are in
/// m/s2.
struct TraceColumn {
  std::string_view name;
  std::string_view in_si;
  Dimension dimension;
};
constexpr auto trace_columns = std::to_array<TraceColumn>(
    {{"tau", "t_s", Dimension::time},
     {"x", "x_m", Dimension::length},
     {"v", "v_m_per_s", Dimension::velocity},
     {"w", "w_m_per_s2", Dimension::gravities},
     {"absolute_acceleration", "absolute_acceleration_m_per_s2", Dimension::gravities},
     {"friction", "friction_m_per_s2", Dimension::gravities}});

}  // namespace

std::string verdict(const MotionReport& report) {
  const Response& response = report.answer.response;
  const auto& forced = report.answer.forced;
  const Physical& physical = report.physical;
  if (forced && forced->locked_from) {
    return *forced->locked_from == 0
               ? "The mass is locked throughout the load."
               : format("The mass locks at x = {} after {}.",
                        length_shown(physical, forced->final_position.value()),
                        time_shown(physical, *forced->locked_from));
  }
  if (!moves(response) && response.outcome != Outcome::caught_at_start) {
    return "The mass never moves.";
  }
  std::string text =
      response.stop_position.value_or(0) != 0
          ? format("The mass stops in the {} at x = {}",
                   response.outcome == Outcome::stopped_in_notch ? "notch" : "dead zone",
                   length_shown(physical, *response.stop_position))
          : format("The mass {}",
                   forced ? outcome_phrase(*forced) : outcome_phrase(response.outcome));
  if (response.stop_time && *response.stop_time > 0) {
    text += format(" after {}", time_shown(physical, *response.stop_time));
  }
  return text + ".";
}

Document document(const MotionReport& report) {
  Document document =
      answered(is_forced(report.request) ? "Forced motion" : "Free motion", report, Tone::plain);
  add_answer(document.answer, report);
  add_findings(document, report.findings, report.physical);
  if (const auto& half_cycles = report.answer.half_cycles; !half_cycles.empty()) {
    add_half_cycles(document.section("Half-cycles"), half_cycles,
                    report.answer.response.half_cycles, report.physical);
  }
  return document;
}

std::vector<std::string_view> trajectory_columns(const Physical& physical) {
  std::vector<std::string_view> names;
  std::ranges::transform(trace_columns, std::back_inserter(names), &TraceColumn::name);
  if (physical) {
    std::ranges::transform(trace_columns, std::back_inserter(names), &TraceColumn::in_si);
  }
  return names;
}

std::vector<double> trajectory_rows(std::span<const TracedState> states, const Physical& physical) {
  std::vector<double> rows;
  rows.reserve(states.size() * trace_columns.size() * (physical ? 2 : 1));
  for (const TracedState& state : states) {
    const auto values = std::bit_cast<std::array<double, trace_columns.size()>>(state);
    rows.insert(rows.end(), values.begin(), values.end());
    for (std::size_t i = 0; physical && i < values.size(); ++i) {
      rows.push_back(*physical->scales.in_si(trace_columns.at(i).dimension, values.at(i)));
    }
  }
  return rows;
}

std::string trajectory_csv(const std::vector<TracedState>& states, const Physical& physical) {
  std::string text = format("{}\n", fmt::join(trajectory_columns(physical), ","));
  auto end = std::back_inserter(text);
  for (const TracedState& state : states) {
    fmt::format_to(end, "{}\n", fmt::join(trajectory_rows({&state, 1}, physical), ","));
  }
  return text;
}

}  // namespace stillpoint::report
