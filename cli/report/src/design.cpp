// SPDX-License-Identifier: MIT
#include "choices.hpp"
#include "design_parts.hpp"
#include "format.hpp"

#include <stillpoint/report/digits.hpp>
#include <stillpoint/report/report.hpp>

namespace stillpoint::report {

namespace {

void add_damper(Document& document, const DesignReport& report, const Physical& physical) {
  const design::DesignResult& result = report.result;
  const design::Finding& finding = *result.finding;
  const DeltaNeeds needs = delta_needs(result);
  const design::DesignPoint& point = finding.point;
  Section& section = document.detail("Damper");
  if (wants_no_friction(report)) {
    section.row("f found", digits(point.f));
  }
  if (stops_by_delta1(finding.constraints)) {
    section.row("Delta1(f)",
                format("{} published, {} exact", length_shown(physical, needs.published),
                       needs.exact ? length_shown(physical, *needs.exact) : "none"));
  }
  add_damper_physics(section, physical, point.f, point.delta);
  add_notch(section, finding.practice, physical);
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
        {{std::string(method_words(method.name)), digits(method.peak_amplitude * units.length),
          digits(stop_time), format("{:.0f}", method.half_cycles),
          format("{:.1e}", method.relative_error), format("{:.1e}", method.tolerance),
          duration_text(method.wall_time_s), judgement(method)},
         method.passed ? Tone::good : Tone::bad});
  }
  Section& section = check.passed ? document.detail("Cross-check: agrees")
                                  : document.section("Cross-check: DISAGREES");
  section.parts.emplace_back(std::move(table));
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

void add_motion(Document& document, const design::Finding& finding, const Physical& physical) {
  if (finding.pulse) {
    add_pulse_check(document, *finding.pulse, physical);
  } else {
    add_response(document.detail("Motion"), finding.response, physical);
  }
  add_practice(document.detail("In practice"), finding.practice, physical);
}

/// A value of the objective, in the units of the task.
std::string objective_text(design::Objective objective, double value, const Physical& physical) {
  switch (objective) {
    case design::Objective::robust:
      break;
    case design::Objective::amplitude:
      return length_text(physical, value);
    case design::Objective::time:
      return time_text(physical, value);
    case design::Objective::acceleration:
      return digits(value) + " g";
  }
  return digits(value);
}

/// How NLopt ended, by its status.
std::string_view ended(std::string_view status) {
  return status == "SUCCESS" || status.ends_with("TOL_REACHED") ? "converged"
         : status.starts_with("MAX")                            ? "its budget was spent"
                                     : "no step was better than the start";
}

void add_search(Document& document, const design::SearchRecord& search,
                const design::DesignResult& result, const Physical& physical) {
  const design::Objective objective = result.request.search.objective;
  Section& sought = document.detail("Search");
  sought.line(format("NLopt {} {}: {} after {} evaluations, {:.2g} ms", design::nlopt_version(),
                     search.algorithm, ended(search.status), search.evaluations,
                     1e3 * search.wall_time_s));
  const Optimum optimum = optimum_of(result);
  if (optimum.along_f) {
    const std::string found = objective_text(objective, *optimum.found, physical);
    const std::string along_f = objective_text(objective, *optimum.along_f, physical);
    sought.line(
        format("{} {}: {}; by a search along f alone, without NLopt: {}{}",
               objective == design::Objective::robust ? "tolerance" : name(objective),
               result.request.pulse ? "by NLopt" : "of the design", found, along_f,
               result.request.pulse && found != along_f ? "; the better one is built" : ""));
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
  const auto add_posed = [&] {
    add_task(document, result.request, physical);
    if (result.request.pulse) {
      add_pulse_region(document, result, physical);
    } else {
      add_region(document, result.region, physical);
    }
  };
  if (!result.finding) {
    add_emptiness(document, result, {problem, limits, pulse, physical});
    if (report.catalogue) {
      const design::RatedPart& best = report.catalogue->parts.front();
      if (best.tolerance) {  // it is admissible but for that
        document.verdict = format("No admissible design. No part has {}; the best, {}, has {}.",
                                  tolerance_shown(limits, limits.tolerance), best.part.name,
                                  tolerance_shown(limits, *best.tolerance));
      }
      add_parts(document, *report.catalogue, {problem, limits, physical});
    }
    add_posed();
    return document;
  }
  const design::Finding& finding = *result.finding;
  document.verdict = verdict(report, physical);
  const bool sound = finding.cross_check.passed && built_notch_fault(report, physical).empty();
  document.tone = sound ? Tone::good : Tone::bad;
  add_answer(document.answer, report, physical);
  add_choices(document, report, physical);
  if (report.built_notch) {
    add_built_notch(document, *report.built_notch, finding, physical);
  }
  add_posed();
  add_damper(document, report, physical);
  add_constraints(document, finding.constraints, physical);
  add_motion(document, finding, physical);
  add_checks(document, finding.cross_check, physical);
  if (finding.search) {
    add_search(document, *finding.search, result, physical);
  }
  return document;
}

}  // namespace stillpoint::report
