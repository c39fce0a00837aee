// SPDX-License-Identifier: MIT
#include "format.hpp"
#include "json/motion_fields.hpp"
#include "rows.hpp"
#include "sections.hpp"

#include <stillpoint/design/motion_findings.hpp>
#include <stillpoint/report/digits.hpp>
#include <stillpoint/report/findings.hpp>
#include <stillpoint/report/report.hpp>

#include <iterator>
#include <string_view>

namespace stillpoint::report {

namespace {

/// Where the largest transmitted acceleration is felt, if there is a notch. While the mass slides
/// it is at most that of the peak: docs/theory.md section 11.
std::string felt_where(const MotionReport& report) {
  const auto& [p, f, delta, hold] = report.request.oscillator;
  const Response& response = report.answer.response;
  const auto& forced = report.answer.forced;
  const bool wide = report.request.surface.notch_width.has_value();
  const bool acts = delta > 0 && response.peak_amplitude > 0;
  if (forced && forced->largest_load_while_locked == response.peak_absolute_acceleration) {
    return " while it is locked";
  }
  if (!acts) {
    return "";
  }
  const auto& [notch_width, zones] = report.request.surface;
  const auto outside = zones.empty() ? felt_outside(response.peak_absolute_acceleration,
                                                    response.peak_amplitude, p, f, notch_width)
                                     : std::nullopt;
  if (wide) {
    return outside && report.request.start.x0 == 0
               ? format(" inside the notch, {} outside it", acceleration_shown(*outside))
               : ", the notch included";
  }
  return hold && outside               ? " while the notch holds it"
         : forced && response.jump > 0 ? " between the jumps"
                                       : ", outside the notch";
}

void add_answer(Section& answer, const MotionReport& report) {
  const auto& [p, f, delta, hold] = report.request.oscillator;
  const Response& response = report.answer.response;
  const Physical& physical = report.physical;
  const auto& zones = report.request.surface.zones;
  answer.row("damper",
             format("f = {}{}, delta = {}", digits(f),
                    zones.empty() ? "" : " beyond " + length_shown(physical, zones.back().to),
                    length_shown(physical, delta)));
  if (report.record) {
    answer.row("record", record_words(report.record->file, report.record->factor,
                                      report.record->units_read, report.record->assumed,
                                      design::largest_load(report.request.excitation)));
  }
  add_surface(answer, report.request, physical);
  if (moves(response)) {
    answer.row("peak", length_shown(physical, response.peak_amplitude), Tone::heading);
  }
  if (report.answer.forced || moves(response)) {
    answer.row("acceleration",
               format("{} transmitted{}", acceleration_shown(response.peak_absolute_acceleration),
                      felt_where(report)));
  }
  if (report.answer.forced && report.answer.forced->left_notch_from_rest) {
    const double centre = design::friction_at_centre(report.request);
    const double width =
        design::least_width(centre, delta, design::largest_load(report.request.excitation));
    if (width < 2 * response.peak_amplitude) {
      answer.row("start",
                 format("needs a notch wider than {}, delta/(load - {})",
                        length_limit(physical, width, true), zones.empty() ? "f" : digits(centre)));
    }
  }
  if (report.answer.forced && response.outcome == Outcome::running) {
    const ForcedResponse& forced = *report.answer.forced;
    answer.row("at the end", format("x = {} at {}", length_shown(physical, *forced.final_position),
                                    time_shown(physical, *forced.end_time)));
  }
}

}  // namespace

std::string verdict(const MotionReport& report) {
  const Response& response = report.answer.response;
  const auto& forced = report.answer.forced;
  const Physical& physical = report.physical;
  if (forced && forced->locked_from) {
    return *forced->locked_from == 0
               ? "It is locked throughout the load."
               : format("It locks at x = {} after {}.",
                        length_shown(physical, forced->final_position.value()),
                        time_shown(physical, *forced->locked_from));
  }
  if (!moves(response) && response.outcome != Outcome::caught_at_start) {
    return "It never moves.";
  }
  std::string text =
      response.stop_position.value_or(0) != 0
          ? format("It stops in the {} at x = {}",
                   response.outcome == Outcome::stopped_in_notch ? "notch" : "dead zone",
                   length_shown(physical, *response.stop_position))
          : format("It {}", forced ? outcome_phrase(*forced) : outcome_phrase(response.outcome));
  if (response.stop_time && *response.stop_time > 0) {
    text += format(" after {}", time_shown(physical, *response.stop_time));
  }
  return text + ".";
}

Document document(const MotionReport& report) {
  const auto& [p, f, delta, hold] = report.request.oscillator;
  const Start& start = report.request.start;
  Document document;
  document.title = is_forced(report.request) ? "Forced motion" : "Free motion";
  document.verdict = verdict(report);
  add_answer(document.answer, report);
  add_findings(document, report.findings, report.physical);
  Section& scene = document.detail("Scene");
  if (report.physical) {
    add_physical_input(scene, *report.physical);
  }
  scene.row("dimensionless", format("v0 = {:.6g}, p = {:.6g}, x0 = {:.6g}, delta = {:.6g}",
                                    start.v0, p, start.x0, delta));
  if (is_forced(report.request)) {
    add_excitation(scene, report.request.excitation, report.record, report.physical);
  }
  if (const Response& response = report.answer.response; moves(response)) {
    Section& motion = document.detail("Motion");
    add_rows(motion, response, report.physical);
    if (response.outcome == Outcome::running) {
      add_rows(motion, forced_fields, *report.answer.forced, report.physical);
    }
  }
  if (const auto lines = practice_of(report)) {
    add_rows(document.detail("In practice"), ShownPractice{*lines}, report.physical);
  }
  if (const auto si = physical_of(report); si && report.physical->scales.mass_kg) {
    Section& forces = document.detail("Forces and energies");
    add_si_rows(forces, damper_fields, *si);
    add_si_rows(forces, practice_fields_si, *si);
  }
  if (const auto& half_cycles = report.answer.half_cycles; !half_cycles.empty()) {
    add_half_cycles(document.section("Half-cycles"), half_cycles,
                    report.answer.response.half_cycles, "lists more, see --max-half-cycles",
                    report.physical);
  }
  return document;
}

}  // namespace stillpoint::report
