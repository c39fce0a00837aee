// SPDX-License-Identifier: MIT
#include "design_parts.hpp"
#include "format.hpp"

#include <cmath>

namespace stillpoint::report {

void add_built_notch(Document& document, const design::BuiltNotch& built,
                     const design::Finding& finding, const Physical& physical) {
  const auto& [shape, friction, response, changes_nothing] = built;
  const Response& paper = finding.pulse ? finding.pulse->response : finding.response;
  Section& section = document.section("With the notch as built");
  if (shape.width) {
    section.row("width", length_text(physical, *shape.width));
    section.row("friction inside", format("f + delta/width = {:.6g}", *friction));
  } else {
    section.row("holds",
                format("f + hold = {:.4g} g at x = 0", finding.point.f + shape.hold.value()));
    if (changes_nothing) {
      section.line("No load exceeds that while the mass is at rest there: nothing changes.");
      return;
    }
  }
  if (response.half_cycles == 0) {
    section.line("This notch holds the mass throughout the pulse.", Tone::bad);
    return;
  }
  section.row("outcome", outcome_phrase(response.outcome));
  section.row("peak", length_text(physical, response.peak_amplitude));
  if (response.stop_position && response.stop_time) {
    section.row("rest", format("x = {}", length_text(physical, *response.stop_position)));
    section.row("stop time", time_text(physical, *response.stop_time));
  }
  if (response.stop_time && paper.stop_time) {
    section.row("change", format("stops {:.3g} % {} than with the paper's notch",
                                 100 * std::abs(*response.stop_time / *paper.stop_time - 1),
                                 *response.stop_time < *paper.stop_time ? "earlier" : "later"));
  }
  section.row("acceleration",
              format("up to {:.4g} g is transmitted, {} ({:.4g} g outside the paper's notch)",
                     response.peak_absolute_acceleration,
                     shape.width ? "the notch included" : "outside the notch",
                     paper.peak_absolute_acceleration));
}

}  // namespace stillpoint::report
