// SPDX-License-Identifier: MIT
#include "format.hpp"
#include "sections.hpp"

#include <stillpoint/records/decimal.hpp>
#include <stillpoint/report/digits.hpp>

#include <algorithm>
#include <cmath>

namespace stillpoint::report {

std::optional<double> felt_outside(const Response& response, double p, double f,
                                   const std::optional<double>& notch_width) {
  // It slides at the largest acceleration outside, f + p^2 |x|, where it is farthest.
  const double outside = f + p * p * response.peak_amplitude;
  const bool leaves = notch_width.value_or(0) / 2 < response.peak_amplitude;
  return leaves && response.peak_absolute_acceleration > for_rounding * outside
             ? std::optional(outside)
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
  return response.outcome != Outcome::running || response.final_velocity != 0
             ? outcome_phrase(response.outcome)
         : response.peak_amplitude == 0 ? "has not moved by the end of the run"
                                        : "is at rest at the end of the run";
}

// The margins of the two motions are different quantities: docs/theory.md section 6,
// docs/forced.md section 7.
std::string_view closest_decision() {
  return "how close a decision, to stick or to pass x = 0, came to going the other way; not a "
         "tolerance of the inputs";
}

namespace {

/// " (strongest hit, softest spring)"; empty without ranges of them.
std::string of_extreme(const ShownTask& task, std::string_view spring) {
  const std::string which = task.pulse ? "" : extreme_words(task.problem, spring);
  return which.empty() ? "" : format(" ({})", which);
}

}  // namespace

std::string felt(const ShownTask& task, const design::DesignPoint& damper, const ToldMotion& motion,
                 const ToldPractice& practice, const std::string& inside) {
  const auto& [problem, limits, pulse, ranges, physical] = task;
  const auto& [f, delta, tolerance] = damper;
  const double most = !pulse         ? std::hypot(f, problem.stiffest_p() * problem.v0)
                      : motion.worst ? motion.worst->acceleration
                                     : motion.response.peak_absolute_acceleration;
  const std::string outside =
      format("{} outside the notch{}", acceleration_shown(most), of_extreme(task, "stiffest"));
  const auto& lines = practice.lines;
  if (delta == 0) {
    return acceleration_shown(most) + of_extreme(task, "stiffest");
  }
  if (!inside.empty()) {
    return format("{}; {}", outside, inside);
  }
  if (lines && limits.acceleration_max && !pulse) {
    // The least width is known only for a stop at x = 0.
    return format("{}; inside it, {} {}", outside,
                  motion.arrival && !problem.has_caught_hits(delta)
                      ? "at any width more than"
                      : "no width is known to keep it within",
                  acceleration_shown(*limits.acceleration_max));
  }
  return format(
      "{}, {}", outside,
      inside_words(physical, {problem.stiffest_p(), f, delta}, motion.response.peak_amplitude,
                   pulse ? design::peak_load(*pulse) : HUGE_VAL));
}

namespace {

/// Of a limit, with the digits that tell it from all of the limit.
std::string share_of(double value, double limit) {
  constexpr double all = 100;  // per cent
  constexpr double least = 0.01;
  constexpr int every = 17;  // digits that a double has
  const double share = all * value / limit;
  if (share < least) {
    return format("less than {} %", least);
  }
  constexpr double rounding = 1e-9;
  int shown = 4;
  while (std::abs(share - all) > rounding && shown < every &&
         records::decimal(share, shown) == all) {
    ++shown;
  }
  return format("{:.{}g} %", share, shown);
}

/// "any hit: within 50 mm; strongest hit: x = -7.7572 mm after 3.3876 s": the motion shown may rest
/// much closer than others. Empty if the residual of ranges is not what counts.
std::string rest_of_ranges(const ShownTask& task, const ToldMotion& motion) {
  const auto& [problem, limits, pulse, ranges, physical] = task;
  const double residual = std::min(problem.residual.value_or(0), problem.beta);
  const std::string shown = extreme_words(problem, "softest");
  return shown.empty() || residual == 0 || !motion.admissible
             ? ""
             : format("any {}{}{}: within {}; {}: x = {} after {}", problem.v0_low ? "hit" : "",
                      problem.v0_low && problem.p_high ? " and " : "",
                      problem.p_high ? "spring" : "", length_shown(physical, residual), shown,
                      length_shown(physical, *motion.response.stop_position),
                      time_shown(physical, *motion.response.stop_time));
}

}  // namespace

void add_motion(Section& answer, const ShownTask& task, const ToldMotion& motion,
                const std::string& acceleration) {
  const auto& [problem, limits, pulse, ranges, physical] = task;
  const auto& [response, arrival, worst, admissible, tried] = motion;
  const bool ranged = pulse && design::pulse_problem(problem, *pulse, ranges).has_ranges();
  // The requirements are about the motion up to its first return.
  const std::string under_pulse =
      format(", under the pulse{}{}", ranged && !worst ? " shown" : "",
             response.zero_passages.value_or(0) > 0 ? ", later swings included" : "");
  const double peak = tried ? tried->peak : response.peak_amplitude;
  answer.row("peak",
             format("{}, {} of the {} allowed{}", length_shown(physical, peak),
                    share_of(peak, problem.beta), length_shown(physical, problem.beta),
                    tried   ? tried->of_peak
                    : pulse ? under_pulse
                            : of_extreme(task, "softest")),
             peak > problem.beta * for_rounding ? Tone::bad : Tone::plain);
  if (!response.stop_time || response.half_cycles == 0) {
    answer.row(
        "rest",
        response.stop_time ? "at x = 0 throughout" : "none: it " + outcome_phrase(response.outcome),
        Tone::bad);
  } else if (tried) {
    answer.row("rest", tried->rest, tried->rests_far ? Tone::bad : Tone::plain);
  } else if (const std::string all = rest_of_ranges(task, motion); !all.empty()) {
    answer.row("rest", all);
  } else {
    answer.row("rest",
               format("at x = {}{} {} {}{}{}", length_shown(physical, *response.stop_position),
                      response.outcome == Outcome::stopped_in_notch ? ", inside the notch," : "",
                      worst ? "within" : "after",
                      time_shown(physical, worst ? worst->stop_time : *response.stop_time),
                      arrival && problem.arrivals > 1 ? format(", at arrival {}", *arrival) : "",
                      of_extreme(task, "softest")));
  }
  answer.row("acceleration", acceleration);
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
                           : "it may stop elsewhere if all inputs shift by about this much"));
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
    section.row(
        "transmitted",
        format("{:.6g} g, the largest acceleration that the structure feels{}",
               response.peak_absolute_acceleration, between_jumps(physical, response.jump)));
  }
  if (moves(response)) {
    section.row("peak", length_shown(physical, response.peak_amplitude));
    section.row("relative", format("{:.6g} g, the largest acceleration relative to the base",
                                   response.peak_acceleration));
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
