// SPDX-License-Identifier: MIT
#include "design_parts.hpp"
#include "format.hpp"
#include "sentence.hpp"

#include <stillpoint/design/tolerance.hpp>
#include <stillpoint/records/decimal.hpp>
#include <stillpoint/report/digits.hpp>

#include <cmath>
#include <numbers>

namespace stillpoint::report {

namespace {

constexpr double buildable = 0.01;  // a smaller tolerance is too little for a real damper

/// The friction of the design, rounded so that it is still feasible: to six digits, or to more
/// where none of six is.
double shown_f(const design::DesignResult& result) {
  constexpr int fewest = 6;
  constexpr int every = 17;  // that a double has
  using enum records::Rounding;
  const double f = result.finding->point.f;
  for (int shown = fewest; shown < every; ++shown) {
    for (const records::Rounding rounding : {nearest, up, down}) {
      const double found = records::decimal(f, shown, rounding);
      if (*result.region.f_lower <= found && found <= *result.region.f_upper) {
        return found;
      }
    }
  }
  return f;
}

/// Beside next to no friction: what is left of it with friction that can be built.
std::string tolerance_without_friction(const design::DesignResult& result) {
  const auto& [f, delta, tolerance] = result.finding->point;
  std::string text =
      format("delta may be off by +-{} with next to no f", percent_digits(tolerance));
  if (!result.request.pulse) {
    constexpr double kept = 0.9;
    const auto& [problem, limits, search, pulse, ranges] = result.request;
    const double less = records::decimal(kept * tolerance, 2);
    if (const auto largest = design::any_f_up_to(problem, limits, delta, less)) {
      constexpr int shown = 3;
      text += format(", by +-{} with any f up to {}", percent_digits(less),
                     limit_digits(*largest, false, shown));
    }
  }
  return text;
}

/// Of a hit, with a box of delta alone: whether f has next to no room.
bool is_f_on_an_edge(const design::DesignRequest& request, const design::DesignPoint& point) {
  design::Limits alone = request.limits;
  const bool asked = alone.shape.f_low + alone.shape.f_high > 0;
  alone.shape = {1, 1, 0, 0};
  return !asked && !request.pulse &&
         design::largest_tolerance(request.problem, alone, point.f, point.delta).value_or(0) <
             buildable;
}

std::string tolerance_left(const DesignReport& report) {
  const design::Limits& limits = report.result.request.limits;
  const auto& [f, delta, tolerance] = report.result.finding->point;
  return wants_no_friction(report) && leaves_any(tolerance) && limits.shape == design::BoxShape{}
             ? tolerance_without_friction(report.result)
             : tolerance_words(limits, tolerance, delta);
}

std::string checks_agree(const design::CrossCheck& check) {
  std::string text = "agree";
  for (const design::CheckMethod& method : check.methods) {
    text +=
        format("{} {} {}", text == "agree" ? ":" : ",", method_words(method.name),
               method.relative_error == 0 ? "exactly" : format("to {:.1e}", method.relative_error));
  }
  return text;
}

/// For the ranges of a pulse: how far what is above holds, and which of them is shown.
void add_worst(Section& answer, const DesignReport& report, const Physical& physical) {
  const design::DesignRequest& request = report.result.request;
  const bool springs = request.problem.p_high.has_value();
  const bool lengths = request.pulse_ranges.lambda_high.has_value();
  answer.row(
      "ranges",
      format(
          "all of this holds for every pulse{} of the ranges{}", springs ? " and spring" : "",
          springs || lengths ? "; durations and periods between those tried are estimated" : ""));
  if (!report.built_notch) {
    answer.row("", format("the motion shown has the largest peak, with {}",
                          shown_motion(report, physical)));
  }
}

/// Under a pulse, where only the tolerance asks for a strong notch. A part has the one that it has.
std::string unbounded_words(const DesignReport& report, const Physical& physical) {
  const design::DesignResult& result = report.result;
  constexpr double far_beyond = 3;  // times what stops the mass
  if (!result.request.pulse || result.request.limits.delta_max || report.catalogue) {
    return {};
  }
  const DeltaNeeds needs = delta_needs(result);
  const bool exact = result.request.problem.criterion == design::Criterion::exact;
  const double least = exact ? needs.exact.value_or(0) : *needs.published;
  return result.finding->point.delta > far_beyond * least
             ? format(
                   " Nothing bounds delta: it could be anything above {}, and is this large only "
                   "for the tolerance. Give --delta-max{}, say {}, to keep the notch small.",
                   length_shown(physical, least), physical ? "-m" : "",
                   length_shown(physical, of_two_digits(physical, far_beyond * least)))
             : "";
}

}  // namespace

std::string_view method_words(std::string_view name) {
  return name == "half_cycle_map" ? "half-cycle map"
         : name == "forced_pulse" ? "forced motion"
         : name == "runge_kutta"  ? "Runge-Kutta"
                                  : name;
}

std::string shown_motion(const DesignReport& report, const Physical& physical) {
  const auto& [problem, limits, search, pulse, ranges] = report.result.request;
  const auto& check = report.result.finding->pulse;
  const FigureUnits units(physical);
  std::string shown;
  if (check && check->worst) {
    shown = format("k = {:.6g} g", design::peak_load(check->pulse));
    if (ranges.lambda_high) {
      shown += ", a pulse of " +
               time_shown(physical, duration(design::excitation(check->pulse)).value());
    }
  } else if (problem.v0_low) {
    shown = format("the strongest hit, {}{}",
                   physical ? "" : "v0 = ", units.velocity_words(problem.v0));
  }
  if (problem.p_high) {
    shown += format("{}{}",
                    shown.empty() ? ""
                    : check       ? " and "
                                  : ", and ",
                    check ? spring_words(physical, check->p)
                          : "the softest spring, " +
                                (physical ? units.time_words(2 * std::numbers::pi / problem.p)
                                          : format("p = {:.4g}", problem.p)));
  }
  return shown;
}

bool wants_no_friction(const DesignReport& report) {
  const design::DesignResult& result = report.result;
  return !report.catalogue && begins_at_nothing(result.finding->point.f,
                                                std::max(*result.region.f_upper, result.region.f3));
}

bool is_too_exact(const DesignReport& report) {
  const design::DesignRequest& request = report.result.request;
  const design::DesignPoint& point = report.result.finding->point;
  return !report.catalogue && !wants_no_friction(report) &&
         (point.tolerance < buildable || is_f_on_an_edge(request, point));
}

std::string verdict(const DesignReport& report, const Physical& physical) {
  const design::Found& finding = *report.result.finding;
  const auto& [f, delta, tolerance] = finding.point;
  const auto shape = report.built_notch ? report.built_notch->shape : design::NotchShape();
  std::optional<double> friction;
  if (!wants_no_friction(report)) {
    friction = physical && physical->scales.mass_kg ? f : shown_f(report.result);
  }
  const std::string fault = notch_sentence(report);
  const bool none_works = !fault.empty() && !report.built_notch;
  const std::string what =
      report.catalogue
          ? format("order part {}: f = {}, delta = {}", report.catalogue->parts.front().part.name,
                   digits(f), length_shown(physical, delta))
          : format("{} {}",
                   !is_too_exact(report) ? "build"
                   : none_works          ? "the damper found is too exact to be built:"
                                         : "too exact to be built:",
                   damper_words(physical, friction, delta, shape));
  return (none_works ? format("{} With a notch that {}, {}.", sentence(fault), acts_late, what)
                     : sentence(what)) +
         remarks(report, physical);
}

std::string remarks(const DesignReport& report, const Physical& physical) {
  const std::string fault = notch_sentence(report);
  const double delta = report.result.finding->point.delta;
  std::string text;
  if (physical && !physical->scales.mass_kg && delta > 0 && fault.empty()) {
    text +=
        " Delta is an energy, not a size: each passage takes as much as lifting the mass by that "
        "height.";
  }
  text += unbounded_words(report, physical);
  if (!fault.empty() && report.built_notch) {
    text += format(" But {}.", fault);
  } else {
    text += next_sentence(lock_sentence(report));
  }
  text += late_notch_words(report);
  if (!report.result.finding->cross_check.passed) {
    text += " But the cross-check DISAGREES: do not rely on this design.";
  }
  return text;
}

std::string felt_words(const DesignReport& report, const Physical& physical) {
  const design::Found& finding = *report.result.finding;
  const auto& [f, delta, tolerance] = finding.point;
  const auto built = felt_in_built_notch(report);
  return built ? *built
               : felt(task_of(report), finding.point,
                      {finding.response, finding.arrival,
                       finding.pulse ? finding.pulse->worst : std::nullopt},
                      told_practice(task_of(report), finding.practice, f, delta),
                      inside_limit(report, physical));
}

void add_answer(Section& answer, const DesignReport& report, const Physical& physical) {
  const design::DesignResult& result = report.result;
  const auto& [problem, limits, search, pulse, ranges] = result.request;
  const design::Found& finding = *result.finding;
  const auto& [f, delta, tolerance] = finding.point;
  const bool failing = !notch_sentence(report).empty();
  answer.row("damper",
             format("{}, delta = {}{}",
                    wants_no_friction(report) ? "f as small as you can make it"
                                              : format("f = {}", shown_f(result)),
                    length_shown(physical, delta),
                    failing && !report.built_notch ? format(" ({})", acts_late) : ""),
             Tone::heading);
  add_brake(answer, physical, f);
  ToldMotion told{told_motion(report)};
  told.tried = tried_in_built_notch(report, physical);
  told.admissible = !report.built_notch;
  if (!report.built_notch) {
    told.arrival = finding.arrival;
    told.worst = pulse ? finding.pulse->worst : std::nullopt;
  }
  add_motion(answer, task_of(report), told, felt_words(report, physical));
  if (!pulse && !problem.v0_low && !problem.p_high && !finding.arrival && !report.built_notch &&
      delta > 0 && finding.response.zero_passages == 0.0) {
    answer.row("note", "the mass never comes back to the notch: delta has no effect on this hit");
  }
  if (pulse && !report.built_notch && !failing) {
    add_start(answer, start_under_pulse(result), "delta/(k - f)", physical);
  }
  const bool of_ranges = pulse && finding.pulse->worst;
  if (of_ranges && !report.built_notch) {
    add_worst(answer, report, physical);
  }
  if (report.built_notch) {
    if (const auto& strip = report.built_notch->from_start) {
      const std::string extreme = shown_words(task_of(report));
      answer.row("way out", format("if the notch acts: peak {}, rest {}, {}{}",
                                   length_shown(physical, strip->peak_amplitude),
                                   rest_shown(report, strip->stop_position.value_or(0)),
                                   acceleration_shown(strip->peak_absolute_acceleration),
                                   extreme.empty() ? "" : format(" ({})", extreme)));
    }
    const std::string_view ideal = ideal_words(*report.built_notch, finding);
    answer.row("note",
               report.built_notch->changes_nothing
                   ? format("the mass moves as with a notch that {}: nothing changes", ideal)
                   : format("what follows is for a notch that {}", ideal));
    if (of_ranges) {
      add_worst(answer, report, physical);
    }
  }
  const bool robust = result.request.search.objective == design::Objective::robust;
  const bool f_exact = is_f_on_an_edge(result.request, finding.point);
  const std::string_view advice = f_exact ? ", which is on an edge"
                                  : !leaves_any(tolerance)
                                      ? robust ? "" : "; --tolerance keeps it away"
                                  : tolerance < buildable ? ", too little for a real damper"
                                                          : "";
  answer.row("tolerance", tolerance_left(report) + std::string(advice),
             tolerance < buildable || f_exact ? Tone::bad : Tone::plain);
  add_works_for(answer, finding.works_for, task_of(report));
  add_weak_hits(answer, problem, delta, physical);
  if (finding.cross_check.passed) {
    answer.row("checks", checks_agree(finding.cross_check), Tone::good);
  }
}

}  // namespace stillpoint::report
