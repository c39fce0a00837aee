// SPDX-License-Identifier: MIT
#include "sections.hpp"

namespace stillpoint::report {

using design::ShownDamper;

namespace {

/// Of a figure of several motions; under pulses, whose ranges have one, empty.
std::string_view of_ranges(const ShownDamper& shown) {
  const design::Problem& problem = shown.problem;
  return shown.tried() != nullptr || (!shown.pulse && has_ranges(problem, {}, {})) ? " (worst case)"
                                                                                   : "";
}

/// Of the paper's notch, what one with a width adds: the friction there and, at its edge, the
/// spring. The example is one with which it keeps a limit, or 20 mm wide.
std::string inside_words(const ShownDamper& shown, const Physical& physical) {
  if (shown.pulse) {
    return format("{} if the notch holds the mass",
                  acceleration_shown(design::peak_load(*shown.pulse)));
  }
  constexpr double usual_m = 0.02;
  constexpr int digits = 3;
  const auto& [f, delta, tolerance] = shown.point;
  const double part = shown.response.peak_amplitude / 5;
  const double width = shown.limits.acceleration_max && shown.judged.notch_width_min
                           ? *shown.judged.notch_width_min
                           : std::min(part, physical ? usual_m / physical->scales.length_m : part);
  return format(
      "at most {} g inside one {} wide",
      limit_digits(design::notch_acceleration(f, delta, width, shown.problem.stiffest_p()), true,
                   digits),
      length_shown(physical, width, digits));
}

/// "0.0947 g outside the notch, at most 0.325 g inside one 20 mm wide"
std::string felt_words(const ShownDamper& shown, const Physical& physical) {
  const std::string felt = acceleration_shown(shown.felt());
  const std::string_view of = of_ranges(shown);
  if (shown.point.delta == 0) {
    return format("{}{}", felt, of);
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
  if (shown.tried() != nullptr) {
    const std::string farthest = rest_shown(std::abs(shown.tried()->farthest.rest()));
    return (farthest == rest_shown(0) ? "at x = 0" : format("within {} of x = 0", farthest)) +
           std::string(of_ranges(shown));
  }
  const auto arrival = shown.built == nullptr ? shown.judged.arrival : std::nullopt;
  const double residual = std::min(problem.residual.value_or(0), problem.beta);
  const bool several = !of_ranges(shown).empty();
  return format("at x = {} {}{}{}{}", rest_shown(*response.stop_position),
                stop_words(shown, physical),
                arrival && problem.arrivals > 1 ? format(", at arrival {}", *arrival) : "",
                several ? " (with that peak)" : "",
                several && residual > 0 && shown.admissible
                    ? format("; within {} of x = 0 for any other", length_shown(physical, residual))
                    : "");
}

}  // namespace

std::string does_words(const ShownDamper& shown, const Physical& physical) {
  const std::string felt = acceleration_shown(shown.felt());
  if (!moves(shown.response)) {
    return format("the mass never moves, {} transmitted", felt);
  }
  return format("peak {}, {}, {} transmitted{}", length_shown(physical, shown.peak()),
                shown.response.stop_time ? "at rest " + stop_words(shown, physical) : "no rest",
                felt, shown.built == nullptr && shown.point.delta > 0 ? " outside the notch" : "");
}

void add_motion(Section& answer, const ShownDamper& shown, const Physical& physical) {
  const Response& response = shown.response;
  if (!moves(response)) {
    answer.row("acceleration", felt_words(shown, physical));
    return;
  }
  const double beta = shown.problem.beta;
  const double peak = shown.peak();
  const bool swings_on = shown.pulse && response.zero_passages.value_or(0) > 0;
  answer.row("peak",
             format("{}, {:.4g} % of the {} allowed{}{}", length_shown(physical, peak),
                    100 * peak / beta, length_shown(physical, beta), of_ranges(shown),
                    swings_on ? ", later swings included" : ""),
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
  return !has_ranges(problem, pulse, shown.ranges)
             ? ""
             : format("{} and {}",
                      pulse ? format("k = {:.6g} g", design::peak_load(shown.under_pulse->pulse))
                            : "a hit of " + units_of(physical).velocity.words(problem.v0),
                      period_words(physical, shown.p()));
}

std::string_view ideal_words(const ShownDamper& shown) {
  return shown.pulse                ? "acts only after the start"
         : shown.built->shape.width ? "has no width"
                                    : "holds any load";
}

}  // namespace stillpoint::report
