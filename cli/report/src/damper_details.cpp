// SPDX-License-Identifier: MIT
#include "damper.hpp"
#include "format.hpp"
#include "json/motion_fields.hpp"
#include "rows.hpp"

#include <stillpoint/core/response_fields.hpp>

namespace stillpoint::report {

void add_details(Document& document, const ShownDamper& shown, const DeltaNeeds& needs) {
  const auto& [problem, limits, pulse, ranges, physical] = shown.task;
  const auto& [f, delta, tolerance] = shown.point;
  const auto heading = [&](std::string_view title, const std::string& which) {
    return format("{}{}{}{}", title, which.empty() ? "" : ": ", which, with_ideal(shown));
  };
  const ToldPractice told = told_practice(shown.task, shown.practice, f, delta);
  const auto si = physical_of(physical, f, delta, shown.practice, told.lines);
  Section& damper = document.detail("Damper" + with_ideal(shown));
  if (needs.published) {
    damper.row("Delta1(f)",
               format("{} published (the paper's), {} exact (the motion's own)",
                      length_limit(physical, *needs.published, true),
                      needs.exact ? length_limit(physical, *needs.exact, true) : "none"));
  }
  if (si) {
    add_si_rows(damper, damper_fields, *si);
  }
  const std::string which = shown_words(shown.task);
  add_rows(document.detail(which.empty() ? "Motion" : "Motion: " + which), shown.response,
           physical);
  if (told.lines) {
    Section& practice = document.detail(heading("In practice", told.which));
    add_rows(practice, ShownPractice{*told.lines}, physical);
    if (si) {
      add_si_rows(practice, practice_fields_si, *si);
    }
  }
  if (problem.arrivals > 1 && !pulse && shown.built == nullptr) {
    add_half_cycles(document.detail(heading("Half-cycles", which)),
                    first_half_cycles({problem.p, f, delta}, {0, problem.v0}, most_half_cycles),
                    shown.response.half_cycles, "lists all impulses", physical);
  }
  if (shown.built == nullptr) {
    return;
  }
  const auto& [shape, friction, response, same, from_start, worst, holds] = *shown.built;
  Section& built = document.detail("The notch as built");
  if (shape.width) {
    built.row("width", length_shown(physical, *shape.width));
    built.row("friction inside", format("f + delta/width = {:.6g}", friction.value()));
  } else {
    built.row("holds", format("f + hold = {:.4g} g at x = 0", f + shape.hold.value()));
  }
  if (from_start) {
    built.row("way out", format("if the notch acts there too: peak {}, {}",
                                length_shown(physical, from_start->peak_amplitude),
                                acceleration_shown(from_start->peak_absolute_acceleration)));
  }
}

}  // namespace stillpoint::report
