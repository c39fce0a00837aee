// SPDX-License-Identifier: MIT
#include "format.hpp"
#include "sections.hpp"

#include <stillpoint/report/digits.hpp>

#include <algorithm>

namespace stillpoint::report {

bool moves(const Response& response) {
  return response.stop_time != 0.0;
}

std::optional<double> felt_outside(const Response& response, double p, double f,
                                   const std::optional<double>& notch_width) {
  // It slides at the largest acceleration outside, f + p^2 |x|, where it is farthest.
  const double outside = f + p * p * response.peak_amplitude;
  constexpr double rounding = 1 + 1e-9;
  const bool leaves = notch_width.value_or(0) / 2 < response.peak_amplitude;
  return leaves && response.peak_absolute_acceleration > rounding * outside ? std::optional(outside)
                                                                            : std::nullopt;
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
      return "never stops: there is no friction where it moves";
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

// The margins of the two motions are different quantities: docs/theory.md section 6,
// docs/forced.md section 7.
std::string_view closest_decision() {
  return "how near the closest decision, to stick or to pass x = 0, was to going the other way; "
         "not a tolerance of the inputs";
}

void add_counts(Section& section, const Response& response, const Physical& physical,
                bool margin_of_inputs) {
  if (moves(response) && response.arrival_speed) {
    section.row("arrival speed",
                format("{}, the last at x = 0",
                       FigureUnits(physical).velocity_words(*response.arrival_speed)));
  }
  if (moves(response) && response.half_cycles) {
    // A mass that passes x = 0 may still stop in a notch with a width.
    const bool wide = response.outcome == Outcome::stopped_in_notch;
    section.row("counts",
                format("{}, {}{}, {}", plural(response.half_cycles, "half-cycle"),
                       plural(response.zero_passages, wide ? "crossing" : "passage"),
                       wide ? " of x = 0" : "", plural(response.turning_points, "turning point")));
  }
  if (response.decision_margin) {
    section.row("decision margin",
                format("{:.2g} %: {}", 100 * *response.decision_margin,
                       !margin_of_inputs ? closest_decision()
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
}

}  // namespace stillpoint::report
