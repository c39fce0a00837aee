// SPDX-License-Identifier: MIT
#include "damper.hpp"
#include "format.hpp"

#include <stillpoint/design/motion_findings.hpp>
#include <stillpoint/report/digits.hpp>

#include <algorithm>
#include <cmath>

namespace stillpoint::report {

using design::ShownDamper;

namespace {

double peak_of(const ShownDamper& shown) {
  return (shown.tried() != nullptr ? shown.tried()->peak.response : shown.response).peak_amplitude;
}

/// " (strongest hit, softest spring)", which of the ranges has the largest of a figure.
std::string whose(const ShownDamper& shown, std::string_view worst_spring) {
  const std::string words = shown.tried() != nullptr ? "worst of the ranges"
                            : shown.pulse            ? ""
                                                     : extreme_words(shown.problem, worst_spring);
  return words.empty() ? "" : format(" ({})", words);
}

/// Of the paper's notch, what one with a width adds.
std::string inside_words(const ShownDamper& shown, const Physical& physical) {
  const auto& [f, delta, tolerance] = shown.point;
  if (shown.pulse) {
    return format("{} if the notch holds the mass",
                  acceleration_shown(design::peak_load(*shown.pulse)));
  }
  if (const auto& most = shown.limits.acceleration_max; most && shown.judged.practice) {
    const auto& width = shown.judged.notch_width_min;
    return width
               ? format("{} inside one {} wide", acceleration_shown(*most),
                        length_limit(physical, *width, true))
               : format("no width is known to keep it within {} inside", acceleration_shown(*most));
  }
  return inside_example(physical, {shown.problem.stiffest_p(), f, delta},
                        shown.response.peak_amplitude);
}

/// "0.0947 g outside the notch (strongest hit), at most 0.325 g inside one 20 mm wide"
std::string felt_words(const ShownDamper& shown, const Physical& physical) {
  const std::string felt = acceleration_shown(shown.felt());
  const std::string of = whose(shown, "stiffest");
  if (shown.point.delta == 0) {
    return felt + of;
  }
  if (shown.built == nullptr) {
    return format("{} outside the notch{}; {}", felt, of, inside_words(shown, physical));
  }
  const auto outside = shown.felt_outside();
  return outside ? format("{} inside the notch{}, {} outside it", felt, of,
                          acceleration_shown(*outside))
                 : format("{}, the notch included{}", felt, of);
}

/// "after 1.4461 s"; over the ranges of a pulse "within 1.4566 s".
std::string stop_words(const ShownDamper& shown, const Physical& physical) {
  const design::PulseWorst* const worst = shown.worst();
  return worst != nullptr ? "within " + time_shown(physical, worst->stop_time)
                          : "after " + time_shown(physical, shown.response.stop_time.value());
}

std::string rest_words(const ShownDamper& shown, const Physical& physical) {
  const Response& response = shown.response;
  const design::Problem& problem = shown.problem;
  if (!response.stop_time) {
    return "none: it " + outcome_phrase(response.outcome);
  }
  // 0 if it is next to nothing of the stroke.
  const auto rest_shown = [&](double x) {
    return length_shown(physical, begins_at_nothing(std::abs(x), response.peak_amplitude) ? 0 : x);
  };
  const std::string of = whose(shown, "softest");
  if (shown.tried() != nullptr) {
    const std::string rest = rest_shown(std::abs(shown.tried()->farthest.rest()));
    return (rest == "0" ? "at x = 0" : format("within {} of x = 0", rest)) + of;
  }
  const double residual = std::min(problem.residual.value_or(0), problem.beta);
  const auto arrival = shown.built == nullptr ? shown.judged.arrival : std::nullopt;
  return format(
      "at x = {} {}{}{}{}", rest_shown(*response.stop_position), stop_words(shown, physical),
      arrival && problem.arrivals > 1 ? format(", at arrival {}", *arrival) : "", of,
      of.empty() || residual == 0 || !shown.admissible
          ? ""
          : format("; within {} of x = 0 for any other", length_shown(physical, residual)));
}

}  // namespace

std::string does_words(const ShownDamper& shown, const Physical& physical) {
  const std::string felt = acceleration_shown(shown.felt());
  if (!moves(shown.response)) {
    return format("the mass never moves, {} transmitted", felt);
  }
  return format("peak {}, {}, {} transmitted{}", length_shown(physical, peak_of(shown)),
                shown.response.stop_time ? "at rest " + stop_words(shown, physical) : "no rest",
                felt, shown.built == nullptr && shown.point.delta > 0 ? " outside the notch" : "");
}

void add_motion(Section& answer, const ShownDamper& shown, const Physical& physical) {
  const Response& response = shown.response;
  const double beta = shown.problem.beta;
  const double peak = peak_of(shown);
  const auto [now, allowed] = told_apart(physical, Dimension::length, peak, beta);
  const bool swings_on = shown.pulse && response.zero_passages.value_or(0) > 0;
  answer.row("peak",
             format("{}, {:.4g} % of the {} allowed{}{}", now, 100 * peak / beta, allowed,
                    whose(shown, "softest"), swings_on ? ", later swings included" : ""),
             design::exceeds(peak, beta) ? Tone::bad : Tone::plain);
  answer.row("rest", rest_words(shown, physical), response.stop_time ? Tone::plain : Tone::bad);
  answer.row("acceleration", felt_words(shown, physical));
  if (shown.pulse && shown.built == nullptr && shown.point.delta > 0) {
    const double load = shown.ranges.k_low.value_or(design::peak_load(*shown.pulse));
    add_start(answer, design::least_width(shown.point.f, shown.point.delta, load), response,
              physical);
  }
}

std::string shown_motion(const ShownDamper& shown, const Physical& physical) {
  const design::Problem& problem = shown.problem;
  const auto& pulse = shown.pulse;
  std::string words;
  if (pulse && !design::pulse_problem(problem, *pulse, shown.ranges).has_ranges()) {
    return words;
  }
  if (pulse) {
    words = format("k = {:.6g} g", design::peak_load(shown.under_pulse->pulse));
    if (shown.ranges.lambda_high) {
      words += ", a pulse of " +
               time_shown(physical, duration(design::excitation(shown.under_pulse->pulse)).value());
    }
  } else if (problem.v0_low) {
    words = format("the strongest hit, {}{}",
                   physical ? "" : "v0 = ", units_of(physical).velocity.words(problem.v0));
  }
  if (problem.p_high) {
    words += format("{}{}{}", words.empty() ? "" : ", and ", pulse ? "" : "the softest spring, ",
                    period_words(physical, shown.p()));
  }
  return words;
}

std::string_view ideal_words(const ShownDamper& shown) {
  return shown.pulse                ? "acts only after the start"
         : shown.built->shape.width ? "has no width"
                                    : "holds any load";
}

}  // namespace stillpoint::report
