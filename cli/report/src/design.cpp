// SPDX-License-Identifier: MIT
#include "choices.hpp"
#include "format.hpp"
#include "sections.hpp"

#include <stillpoint/report/digits.hpp>
#include <stillpoint/report/report.hpp>

#include <algorithm>
#include <cmath>

namespace stillpoint::report {

namespace {

/// The best is at the very end of the feasible f, no constant friction: a limit, which the search
/// comes near and nobody builds.
bool wants_no_friction(const DesignReport& report) {
  const design::DesignResult& result = report.result;
  return !report.catalogue && begins_at_nothing(result.finding->point.f, *result.region.f_upper);
}

/// Beside next to no friction: what is left of it with friction that can be built.
std::string tolerance_without_friction(const design::DesignResult& result) {
  const auto& [f, delta, tolerance] = result.finding->point;
  std::string text = format("delta may be off by +-{:.4g} % with next to no f", 100 * tolerance);
  if (!result.request.pulse) {
    constexpr double kept = 0.9;
    const auto& [problem, limits, search, pulse, ranges] = result.request;
    const double less = kept * tolerance;
    if (const auto largest = design::any_f_up_to(problem, limits, delta, less)) {
      text += format(", by +-{:.4g} % with any up to {:.3g}", 100 * less, *largest);
    }
  }
  return text;
}

std::string tolerance_words(const DesignReport& report) {
  const design::Limits& limits = report.result.request.limits;
  const double tolerance = report.result.finding->point.tolerance;
  constexpr double none = 1e-6;  // the distance that a design keeps from an edge, and rounding
  if (tolerance < none) {
    return "none is left: the damper is on the edge of what is admissible";
  }
  if (limits.shape != design::BoxShape{}) {
    return box_text(limits, tolerance);
  }
  return wants_no_friction(report)
             ? tolerance_without_friction(report.result)
             : format("f and delta may both be off by +-{:.4g} %", 100 * tolerance);
}

void add_damper(Document& document, const DesignReport& report, const Physical& physical) {
  const design::DesignResult& result = report.result;
  const design::Finding& finding = *result.finding;
  const DeltaNeeds needs = delta_needs(result);
  const design::DesignPoint& point = finding.point;
  Section& section = document.detail("Design");
  section.row("f", (wants_no_friction(report) ? "next to none, " : "") + digits(point.f),
              Tone::heading);
  section.row("delta", length_text(physical, point.delta), Tone::heading);
  section.row("tolerance", box_text(result.request.limits, point.tolerance));
  if (stops_by_delta1(finding.constraints)) {
    section.row("Delta1(f)",
                format("{:.6g} published, {} exact", needs.published, digits(needs.exact)));
  }
  add_damper_physics(section, physical, point.f, point.delta);
  add_notch(section, finding.practice, physical);
}

/// "0.28 % more than", "0.28 % less than": the reduced figure against the true one.
std::string off_by(double relative) {
  return format("{:.2g} % {}", 100 * std::abs(relative), relative < 0 ? "less than" : "more than");
}

/// Why the reduction to a velocity is off.
std::string warning_text(design::PulseWarning warning, const design::PulseCheck& check) {
  switch (warning) {
    case design::PulseWarning::pulse_not_short:
      return format("the pulse is not short, p/lambda = {:.3g}", check.shortness);
    case design::PulseWarning::friction_not_small:
      return format("f is not small against k, f/k = {:.3g}", check.friction_ratio);
  }
  return {};
}

/// In one line, for comparison.
std::string reduction_text(const design::PulseCheck& check) {
  if (!check.start) {
    return "not used: this pulse leaves no velocity";
  }
  std::string text = format("not used; with a velocity in its place, the peak would be {} this",
                            off_by(check.peak_error.value_or(0)));
  for (const design::PulseWarning warning : check.warnings) {
    text += "; " + warning_text(warning, check);
  }
  return text;
}

void add_pulse_check(Document& document, const design::PulseCheck& check, double beta,
                     const Physical& physical) {
  Section& section = document.detail("Under the pulse itself");
  section.row("p/lambda, f/k", format("{:.4g}, {:.4g}", check.shortness, check.friction_ratio));
  add_response(section, check.response, physical);
  section.row("use of beta", format("{:.4g} %", 100 * check.response.peak_amplitude / beta));
  section.row("reduction", reduction_text(check));
  if (check.start) {
    section.row("", format("it starts with v0 = {:.6g} at tau = {:.6g}", check.start->speed,
                           check.start->tau));
  }
  if (check.stop_time_error) {
    section.row("", format("its stop time is {} this", off_by(*check.stop_time_error)));
  }
}

/// What a notch that is not the paper's changes.
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

std::string judgement(const design::CheckMethod& method) {
  if (!method.passed) {
    return "disagrees";
  }
  return method.decided ? "agrees" : "agrees in the peak; too close to a tie to compare more";
}

/// In eight characters.
std::string duration_text(double seconds) {
  return seconds < 1e-3 ? format("{:.1f} us", 1e6 * seconds)
         : seconds < 1  ? format("{:.1f} ms", 1e3 * seconds)
                        : format("{:.1f} s", seconds);
}

void add_checks(Document& document, const design::CrossCheck& check, const Physical& physical) {
  const FigureUnits units(physical);
  Table table{{"", in("peak", units.length_unit), in("stop time", units.time_unit), "half-cycles",
               "relative error", "allowed", "time", ""},
              {}};
  for (const design::CheckMethod& method : check.methods) {
    std::optional<double> stop_time = method.stop_time;
    if (stop_time) {
      *stop_time *= units.time;
    }
    table.rows.push_back(
        {{std::string(method.name), digits(method.peak_amplitude * units.length), digits(stop_time),
          format("{:.0f}", method.half_cycles), format("{:.1e}", method.relative_error),
          format("{:.1e}", method.tolerance), duration_text(method.wall_time_s), judgement(method)},
         method.passed ? Tone::good : Tone::bad});
  }
  Section& section = check.passed ? document.detail("Cross-check: agrees")
                                  : document.section("Cross-check: DISAGREES");
  section.parts.emplace_back(std::move(table));
}

/// What to build.
std::string verdict(const DesignReport& report, const Physical& physical) {
  const design::Finding& finding = *report.result.finding;
  const auto& [f, delta, tolerance] = finding.point;
  const auto scales = physical ? std::optional(physical->scales) : std::nullopt;
  const auto force = scales ? scales->friction_force_n(f) : std::nullopt;
  const auto energy = scales ? scales->energy_per_passage_j(delta) : std::nullopt;
  const bool weighed = force && energy && std::isfinite(*energy);
  const std::string notch =
      weighed ? format("a notch that takes {} at a passage", with_unit(*energy, "J"))
              : format("delta = {}", length_shown(physical, delta));
  std::string text =
      wants_no_friction(report)
          ? format("Build {} and as little constant friction as you can.", notch)
      : weighed ? format("Build a friction force of {} and {}.", with_unit(*force, "N"), notch)
                : format("Build f = {} and {}.", digits(f), notch);
  if (report.catalogue) {
    text = format("Order part {}: f = {}, delta = {}.", report.catalogue->parts.front().part.name,
                  digits(f), length_shown(physical, delta));
  }
  if (!finding.cross_check.passed) {
    text += " But the cross-check DISAGREES: do not rely on this design.";
  }
  return text;
}

std::string checks_agree(const design::CrossCheck& check) {
  std::string text = "agree";
  for (const design::CheckMethod& method : check.methods) {
    text +=
        format("{} {} to {:.1e}", text == "agree" ? ":" : ",", method.name, method.relative_error);
  }
  return text;
}

/// The width of a notch: 20 mm, or 1, 2 or 5 times a power of ten if that is above a fifth of the
/// peak.
double example_width_m(double peak_m) {
  constexpr double usual = 0.02;
  const double most = peak_m / 5;
  const double decade = std::pow(10, std::floor(std::log10(most)));
  const double digit = most / decade;
  return std::min(usual, decade * (digit >= 5 ? 5 : digit >= 2 ? 2 : 1));
}

/// What the structure feels: outside the notch, and inside one that has a width.
std::string felt(const design::Finding& finding, const Response& response,
                 const design::Limits& limits, const Physical& physical) {
  const std::string outside = acceleration_shown(response.peak_absolute_acceleration);
  if (finding.practice && finding.practice->notch_width_min) {
    return format("{} outside the notch; {} at most inside one at least {} wide", outside,
                  acceleration_shown(limits.acceleration_max.value()),
                  length_shown(physical, *finding.practice->notch_width_min));
  }
  if (limits.acceleration_max) {
    return format("{} outside the notch; inside it, more than {} at any width", outside,
                  acceleration_shown(*limits.acceleration_max));
  }
  if (!physical) {
    return format("{} outside the notch, f + delta/w inside one of width w", outside);
  }
  const double example_m = example_width_m(response.peak_amplitude * physical->scales.length_m);
  const double inside = design::notch_acceleration(finding.point.f, finding.point.delta,
                                                   example_m / physical->scales.length_m);
  return format("{} outside the notch; {:.3g} g inside one {} wide (f + delta/w)", outside, inside,
                with_unit(example_m, "m"));
}

/// For the ranges of a pulse; a range of only k needs no samples.
void add_worst(Section& answer, const design::PulseCheck& check, bool sampled,
               const Physical& physical) {
  answer.row("ranges", format("up to {}, {} and {} with any pulse and spring in the ranges; the "
                              "motion shown has the largest peak, at lambda = {} and p = {:.6g}{}",
                              length_shown(physical, check.worst->peak),
                              acceleration_shown(check.worst->acceleration),
                              time_shown(physical, check.worst->stop_time),
                              frequency_text(physical, design::angular_frequency(check.pulse)),
                              check.p, sampled ? "; lambda/p is sampled" : ""));
}

/// What it does, and how far it can be trusted.
void add_answer(Section& answer, const DesignReport& report, const Physical& physical) {
  const design::DesignResult& result = report.result;
  const auto& [problem, limits, search, pulse, ranges] = result.request;
  const design::Finding& finding = *result.finding;
  const auto& [f, delta, tolerance] = finding.point;
  const bool pulsed = pulse.has_value();
  const Response& response = pulsed ? finding.pulse->response : finding.response;
  const std::string friction =
      wants_no_friction(report) ? "f as small as you can make it" : format("f = {}", digits(f));
  answer.row("damper", format("{}, delta = {}", friction, length_text(physical, delta)),
             Tone::heading);
  answer.row(
      "peak",
      format("{}, {:.4g} % of the {} allowed{}", length_shown(physical, response.peak_amplitude),
             100 * response.peak_amplitude / problem.beta, length_shown(physical, problem.beta),
             pulsed ? ", under the pulse" : ""));
  if (response.stop_time) {
    answer.row(
        "rest",
        format("at x = {} after {}{}", length_shown(physical, *response.stop_position),
               time_shown(physical, *response.stop_time),
               problem.arrivals > 1 && finding.arrival ? format(", at arrival {}", *finding.arrival)
                                                       : ""));
  }
  answer.row("acceleration", felt(finding, response, limits, physical));
  if (pulsed && finding.pulse->worst) {
    add_worst(answer, *finding.pulse, ranges.lambda_high || problem.p_high, physical);
  } else if (problem.p_high) {  // the motion shown is that of the softest spring
    const double stiffest = std::hypot(f, *problem.p_high * problem.v0);
    answer.row("", format("{} with the stiffest spring", acceleration_shown(stiffest)));
  }
  answer.row("tolerance", tolerance_words(report));
  add_works_for(answer, finding.works_for, physical);
  // A weaker hit than this is caught at the start: rule 4 of docs/theory.md, section 1.
  if (const double caught = std::sqrt(2 * delta); problem.v0_low && *problem.v0_low < caught) {
    const std::string words = FigureUnits(physical).velocity_words(caught);
    answer.row("weak hits", format("below {} are held and felt in full: {}", words,
                                   impulse_shown(physical, caught)));
  }
  if (finding.cross_check.passed) {
    answer.row("checks", checks_agree(finding.cross_check), Tone::good);
  }
  if (pulsed) {
    answer.row("reduction", reduction_text(*finding.pulse));
    constexpr double beyond_use = 0.9;
    if (tolerance > beyond_use && !limits.delta_max) {
      answer.row("note",
                 "nothing bounds delta, so almost any tolerance is possible: --delta-max keeps the "
                 "notch small");
    }
  }
}

/// A pulse is shown in place of the velocity to which it reduces.
void add_task(Document& document, const design::DesignRequest& request, const Physical& physical) {
  const auto& [problem, limits, search, pulse, ranges] = request;
  Section& task = add_problem(document, problem, limits, physical, pulse.has_value());
  if (pulse) {
    add_pulse(task, *pulse, ranges, physical);
  }
  task.row("objective", std::string(name(search.objective)));
}

/// The choice among parts and the front, if requested.
void add_choices(Document& document, const DesignReport& report, const Physical& physical) {
  const auto& [problem, limits, search, pulse, ranges] = report.result.request;
  if (report.catalogue) {
    document.answer.row("catalogue", how_many_fit(report.catalogue->parts));
    add_parts(document, *report.catalogue, {problem, limits, physical});
  }
  if (report.trade_off && !report.trade_off->empty()) {
    document.answer.row("trade-off", trade_off_words(*report.trade_off, physical));
    add_trade_off(document, *report.trade_off, physical);
  }
}

void add_motion(Document& document, const design::Finding& finding, double beta,
                const Physical& physical) {
  if (finding.pulse) {
    add_pulse_check(document, *finding.pulse, beta, physical);
    add_practice(document.detail("In practice"), finding.practice, physical);
    return;
  }
  Section& motion = document.detail("Motion");
  add_response(motion, finding.response, physical);
  motion.row("use of beta", format("{:.4g} %", 100 * finding.response.peak_amplitude / beta));
  add_practice(motion, finding.practice, physical);
}

void add_search(Document& document, const design::DesignResult& result) {
  const design::SearchRecord& search = result.finding->search;
  const design::Objective objective = result.request.search.objective;
  Section& sought = document.detail("Search");
  sought.line(format("NLopt {} {}: {} after {} evaluations, {:.2g} ms", design::nlopt_version(),
                     search.algorithm, search.status, search.evaluations,
                     1e3 * search.wall_time_s));
  const Optimum optimum = optimum_of(result);
  if (optimum.along_f) {
    sought.line(format("{} {}: {}; along f alone: {}",
                       objective == design::Objective::robust ? "tolerance" : name(objective),
                       result.request.pulse ? "by NLopt" : "of the design", digits(*optimum.found),
                       digits(*optimum.along_f)));
  }
}

}  // namespace

Optimum optimum_of(const design::DesignResult& result) {
  const auto& [problem, limits, search, pulse, ranges] = result.request;
  const design::Finding& finding = *result.finding;
  if (pulse) {
    return {finding.pulse->searched, finding.pulse->bracketed};
  }
  Optimum optimum{{}, design::optimum_along_f(problem, limits, search.objective)};
  optimum.found = search.objective == design::Objective::robust
                      ? std::optional(finding.point.tolerance)
                      : design::objective_of(search.objective, finding.response);
  return optimum;
}

Document document(const DesignReport& report) {
  const design::DesignResult& result = report.result;
  const auto& [problem, limits, search, pulse, ranges] = result.request;
  Physical physical = report.physical;
  if (pulse && physical) {
    physical->velocity_m_per_s = 0;
  }
  Document document;
  document.title = "Damper design";
  add_task(document, result.request, physical);
  if (pulse) {
    add_pulse_region(document, result, physical);
  } else {
    add_region(document, result.region, physical);
  }
  if (!result.finding) {
    add_emptiness(document, result, {problem, limits, pulse, physical});
    if (report.catalogue) {
      add_parts(document, *report.catalogue, {problem, limits, physical});
    }
    return document;
  }
  const design::Finding& finding = *result.finding;
  document.verdict = verdict(report, physical);
  document.tone = finding.cross_check.passed ? Tone::good : Tone::bad;
  add_answer(document.answer, report, physical);
  add_choices(document, report, physical);
  add_damper(document, report, physical);
  add_constraints(document, finding.constraints, physical);
  add_motion(document, finding, problem.beta, physical);
  if (report.built_notch) {
    add_built_notch(document, *report.built_notch, finding, physical);
  }
  add_checks(document, finding.cross_check, physical);
  if (!report.catalogue) {  // which is chosen without a search
    add_search(document, result);
  }
  return document;
}

}  // namespace stillpoint::report
