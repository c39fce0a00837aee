// SPDX-License-Identifier: MIT
#include "damper.hpp"
#include "format.hpp"

#include <stillpoint/design/motion_findings.hpp>
#include <stillpoint/report/digits.hpp>

#include <cmath>

namespace stillpoint::report {

namespace {

/// " (strongest hit, softest spring)"; empty of nothing.
std::string in_brackets(const std::string& words) {
  return words.empty() ? "" : format(" ({})", words);
}

/// Of the motions that were tried with the notch as built.
constexpr const char* worst_of_ranges = "worst of the ranges";

/// A figure of the motion, and which motion of the ranges has it.
struct MostOf {
  double value;
  std::string of;
};

MostOf peak_of(const ShownDamper& shown) {
  const auto& worst = shown.built != nullptr ? shown.built->worst : std::nullopt;
  return worst ? MostOf{worst->peak.response.peak_amplitude, worst_of_ranges}
               : MostOf{shown.response.peak_amplitude,
                        shown.task.pulse ? "" : extreme_words(shown.task.problem, "softest")};
}

/// Outside the notch; of a notch as built the most inside it as well.
MostOf felt_of(const ShownDamper& shown) {
  const auto& [problem, limits, pulse, ranges, physical] = shown.task;
  if (shown.built != nullptr) {
    const auto& worst = shown.built->worst;
    return worst ? MostOf{worst->felt.response.peak_absolute_acceleration, worst_of_ranges}
                 : MostOf{shown.response.peak_absolute_acceleration, ""};
  }
  const design::PulseWorst* const worst = shown.worst();
  return pulse ? MostOf{worst != nullptr ? worst->acceleration
                                         : shown.response.peak_absolute_acceleration,
                        ""}
               : MostOf{std::hypot(shown.point.f, problem.stiffest_p() * problem.v0),
                        extreme_words(problem, "stiffest")};
}

/// Of the paper's notch, what one with a width adds.
std::string inside_words(const ShownDamper& shown) {
  const auto& [problem, limits, pulse, ranges, physical] = shown.task;
  const auto& [f, delta, tolerance] = shown.point;
  if (pulse) {
    return format("{} if the notch holds the mass", acceleration_shown(design::peak_load(*pulse)));
  }
  if (shown.judged.practice && limits.acceleration_max) {
    return shown.judged.notch_width_min
               ? format("{} inside one {} wide", acceleration_shown(*limits.acceleration_max),
                        length_limit(physical, *shown.judged.notch_width_min, true))
               : format("no width is known to keep it within {} inside",
                        acceleration_shown(*limits.acceleration_max));
  }
  return inside_example(physical, {problem.stiffest_p(), f, delta}, shown.response.peak_amplitude);
}

/// "0.0947 g outside the notch (strongest hit), at most 0.325 g inside one 20 mm wide"
std::string felt_words(const ShownDamper& shown) {
  const auto& [value, of] = felt_of(shown);
  const std::string felt = acceleration_shown(value);
  if (shown.point.delta == 0) {
    return felt + in_brackets(of);
  }
  if (shown.built == nullptr) {
    return format("{} outside the notch{}; {}", felt, in_brackets(of), inside_words(shown));
  }
  const auto& worst = shown.built->worst;
  const Response& slides = worst ? worst->outside.response : shown.response;
  const double p = worst ? worst->outside.p : shown.p();
  const auto outside =
      felt_outside(value, slides.peak_amplitude, p, shown.point.f, shown.built->shape.width);
  return outside ? format("{} inside the notch{}, {} outside it", felt, in_brackets(of),
                          acceleration_shown(*outside))
                 : format("{}, the notch included{}", felt, in_brackets(of));
}

/// 0 if it is next to nothing of the stroke.
std::string rest_shown(const ShownDamper& shown, double x) {
  const bool centre = begins_at_nothing(std::abs(x), shown.response.peak_amplitude);
  return length_shown(shown.task.physical, centre ? 0 : x);
}

/// "after 1.4461 s"; over the ranges of a pulse "within 1.4566 s".
std::string stop_words(const ShownDamper& shown) {
  const design::PulseWorst* const worst = shown.worst();
  return (worst != nullptr ? "within " : "after ") +
         time_shown(shown.task.physical,
                    worst != nullptr ? worst->stop_time : shown.response.stop_time.value());
}

std::string rest_words(const ShownDamper& shown) {
  const auto& [problem, limits, pulse, ranges, physical] = shown.task;
  const Response& response = shown.response;
  if (!response.stop_time) {
    return "none: it " + outcome_phrase(response.outcome);
  }
  if (shown.built != nullptr && shown.built->worst) {
    const design::TriedMotion& farthest = shown.built->worst->farthest;
    const std::string rest = rest_shown(shown, std::abs(farthest.rest()));
    return (rest == "0" ? "at x = 0" : format("within {} of x = 0", rest)) +
           in_brackets(worst_of_ranges);
  }
  const std::string which = pulse ? "" : extreme_words(problem, "softest");
  const double residual = std::min(problem.residual.value_or(0), problem.beta);
  const auto arrival = shown.built == nullptr ? shown.judged.arrival : std::nullopt;
  return format(
      "at x = {} {}{}{}{}", rest_shown(shown, *response.stop_position), stop_words(shown),
      arrival && problem.arrivals > 1 ? format(", at arrival {}", *arrival) : "",
      in_brackets(which),
      which.empty() || residual == 0 || !shown.admissible
          ? ""
          : format("; within {} of x = 0 for any other", length_shown(physical, residual)));
}

}  // namespace

ShownDamper shown_damper(const DesignReport& report) {
  const design::Found& found = *report.result.finding;
  const auto* const built = report.built_notch ? &*report.built_notch : nullptr;
  return {.task = task_of(report),
          .point = found.point,
          .judged = found,
          .response = built != nullptr ? built->response : found.response,
          .under_pulse = found.pulse ? &*found.pulse : nullptr,
          .built = built};
}

std::optional<ShownDamper> shown_damper(const RegionReport& report) {
  const design::RegionAnswer& answer = report.answer;
  if (!answer.response || !moves(*answer.response)) {
    return std::nullopt;
  }
  return ShownDamper{
      .task = task_of(report),
      .point = {*report.request.f, *report.request.delta, answer.tolerance.value_or(0)},
      .judged = answer,
      .response = *answer.response,
      .under_pulse = answer.under_pulse ? &*answer.under_pulse : nullptr,
      .admissible = answer.tolerance.has_value()};
}

std::string does_words(const ShownDamper& shown) {
  const Response& response = shown.response;
  const Physical& physical = shown.task.physical;
  const double felt = felt_of(shown).value;
  if (!moves(response)) {
    return format("the mass never moves, {} transmitted", acceleration_shown(felt));
  }
  return format("peak {}, {}, {} transmitted{}", length_shown(physical, peak_of(shown).value),
                response.stop_time ? "at rest " + stop_words(shown) : "no rest",
                acceleration_shown(felt),
                shown.built == nullptr && shown.point.delta > 0 ? " outside the notch" : "");
}

void add_motion(Section& answer, const ShownDamper& shown) {
  const auto& [problem, limits, pulse, ranges, physical] = shown.task;
  const Response& response = shown.response;
  const auto& [peak, of] = peak_of(shown);
  const auto [now, allowed] = told_apart(physical, Dimension::length, peak, problem.beta);
  answer.row(
      "peak",
      format("{}, {:.4g} % of the {} allowed{}{}", now, 100 * peak / problem.beta, allowed,
             in_brackets(of),
             pulse && response.zero_passages.value_or(0) > 0 ? ", later swings included" : ""),
      peak > problem.beta * for_rounding ? Tone::bad : Tone::plain);
  answer.row("rest", rest_words(shown), response.stop_time ? Tone::plain : Tone::bad);
  answer.row("acceleration", felt_words(shown));
  if (!pulse || shown.built != nullptr || shown.point.delta == 0) {
    return;
  }
  const double load = ranges.k_low.value_or(design::peak_load(*pulse));
  add_start(answer, design::least_width(shown.point.f, shown.point.delta, load), response,
            physical);
}

std::string shown_motion(const ShownDamper& shown) {
  const auto& [problem, limits, pulse, ranges, physical] = shown.task;
  const FigureUnits units = units_of(physical);
  if (pulse && !design::pulse_problem(problem, *pulse, ranges).has_ranges()) {
    return {};
  }
  std::string words;
  if (pulse) {
    words = format("k = {:.6g} g", design::peak_load(shown.under_pulse->pulse));
    if (ranges.lambda_high) {
      words += ", a pulse of " +
               time_shown(physical, duration(design::excitation(shown.under_pulse->pulse)).value());
    }
  } else if (problem.v0_low) {
    words = format("the strongest hit, {}{}",
                   physical ? "" : "v0 = ", units.velocity.words(problem.v0));
  }
  if (problem.p_high) {
    words += format("{}{}{}", words.empty() ? "" : ", and ", pulse ? "" : "the softest spring, ",
                    period_words(physical, shown.p()));
  }
  return words;
}

std::string_view ideal_words(const ShownDamper& shown) {
  return shown.task.pulse           ? "acts only after the start"
         : shown.built->shape.width ? "has no width"
                                    : "holds any load";
}

std::string with_ideal(const ShownDamper& shown) {
  return shown.built != nullptr ? format(", with a notch that {}", ideal_words(shown)) : "";
}

}  // namespace stillpoint::report
