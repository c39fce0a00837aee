// SPDX-License-Identifier: MIT
#include "choices.hpp"
#include "design_parts.hpp"
#include "format.hpp"
#include "sentence.hpp"

#include <stillpoint/report/digits.hpp>
#include <stillpoint/report/report.hpp>

namespace stillpoint::report {

namespace {

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

void add_checks(Document& document, const design::CrossCheck& check, std::string_view with,
                const Physical& physical) {
  const FigureUnits units(physical);
  Table table{{"", in("peak", units.length_unit), in("stop time", units.time_unit),
               "relative error", "allowed", ""},
              {}};
  for (const design::CheckMethod& method : check.methods) {
    table.rows.push_back(
        {{std::string(method_words(method.name)), digits(method.peak_amplitude * units.length),
          digits(method.stop_time * units.time),
          method.relative_error == 0 ? "0" : format("{:.1e}", method.relative_error),
          format("{:.1e}", method.tolerance), judgement(method)},
         method.passed ? Tone::good : Tone::bad});
  }
  const std::string heading =
      format("Cross-check{}: {}", with, check.passed ? "agrees" : "DISAGREES");
  Section& section = check.passed ? document.detail(heading) : document.section(heading);
  section.parts.emplace_back(std::move(table));
}

/// The choice among parts and the front, if requested.
void add_choices(Document& document, const DesignReport& report, const Physical& physical) {
  if (report.catalogue) {
    document.answer.row("catalogue", how_many_fit(report.catalogue->parts));
    add_parts(document, *report.catalogue, task_of(report));
  }
  if (report.trade_off && !report.trade_off->empty()) {
    document.answer.row("trade-off", trade_off_words(*report.trade_off, physical));
    add_trade_off(document, *report.trade_off, task_of(report));
  }
}

/// The least margin at the ends of the ranges, and what a damper with so little still works for.
void add_margin(Section& section, const design::DesignResult& result, const Physical& physical) {
  const design::Found& finding = *result.finding;
  const auto& [f, delta, tolerance] = finding.point;
  std::optional<double> least;
  const auto ends = design::ends_of_ranges(result.request.problem);
  for (const design::Problem& end : ends) {
    const auto margin = free_response({end.p, f, delta}, {0, end.v0}).decision_margin;
    least = least && margin ? std::min(least, margin) : std::max(least, margin);
  }
  if (!least) {
    return;
  }
  std::string serves;
  if (const auto& works = finding.works_for) {
    const FigureUnits units(physical);
    const Interval asked = asked_hits(result.request.problem);
    const std::string own = own_limit_of_hits(*works, result.request.problem);
    serves =
        format("; it works {}for hits of {}{}{}", own.empty() ? "only " : "",
               interval_text({works->hit.low * units.velocity, *works->hit.high * units.velocity},
                             {asked.low * units.velocity, asked.high * units.velocity}),
               with_blank(units.velocity_unit), own);
  }
  section.row(
      "decision margin",
      format("{:.2g} %{}: it may stop elsewhere if all inputs shift by about this much{}",
             100 * *least, ends.size() > 1 ? " at the worst end of the ranges" : "", serves));
}

/// Of the motion with the paper's notch. Its peak, acceleration and rest are in the answer.
void add_motion(Document& document, const DesignReport& report, const Physical& physical) {
  const design::Found& finding = *report.result.finding;
  const auto heading = [&report](std::string_view title, const std::string& which) {
    return format("{}{}{}{}", title, which.empty() ? "" : ": ", which, with_ideal(report));
  };
  Section& motion = document.detail(
      heading(finding.pulse ? "Under the pulse itself" : "Motion", shown_words(task_of(report))));
  Response response = finding.response;
  if (!finding.pulse) {
    response.decision_margin = {};
  }
  add_counts(motion, response, physical, !finding.pulse);
  if (!finding.pulse) {
    add_margin(motion, report.result, physical);
  }
  const ToldPractice told =
      told_practice(task_of(report), finding.practice, finding.point.f, finding.point.delta);
  add_practice(document.detail(heading("In practice", told.which)), told, physical);
  if (const design::Problem& problem = report.result.request.problem; problem.arrivals > 1) {
    const auto& [f, delta, tolerance] = finding.point;
    add_half_cycles(document.detail(heading("Half-cycles", shown_words(task_of(report)))),
                    first_half_cycles({problem.p, f, delta}, {0, problem.v0}, most_half_cycles),
                    response.half_cycles, "lists all impulses", physical);
  }
}

void add_search(Document& document, const design::SearchRecord& search,
                const design::DesignResult& result) {
  Section& sought = document.detail("Search");
  sought.row("NLopt", format("{} {}, {} after {}, {:.2g} ms", design::nlopt_version(),
                             search.algorithm, status_words(search.status),
                             plural(static_cast<double>(search.evaluations), "evaluation"),
                             1e3 * search.wall_time_s));
  const auto [found, along_f] = optimum_of(result);
  if (along_f) {
    const bool same = digits(found) == digits(along_f);
    sought.row("without NLopt",
               same ? "a search along f alone finds the same optimum"
                    : format("a search along f alone finds {}, NLopt {}; the better one is built",
                             digits(along_f), digits(found)));
  }
}

}  // namespace

std::string status_words(std::string_view status) {
  return status == "XTOL_REACHED" || status == "FTOL_REACHED" || status == "SUCCESS" ||
                 status == "STOPVAL_REACHED"
             ? "converged"
         : status == "ROUNDOFF_LIMITED" ? "converged as far as rounding allows"
         : status == "MAXEVAL_REACHED"  ? "stopped at its limit of evaluations"
         : status == "MAXTIME_REACHED"  ? "stopped at its limit of time"
                                        : format("no step improved the start ({})", status);
}

Optimum optimum_of(const design::DesignResult& result) {
  const auto& search = result.finding->search;
  return search ? Optimum{search->by_nlopt, search->along_f} : Optimum();
}

Tone tone_of(const DesignReport& report) {
  const bool sound = report.result.finding && report.result.finding->cross_check.passed &&
                     notch_sentence(report).empty() && !is_too_exact(report);
  return sound ? Tone::good : Tone::bad;
}

Advice advice(const DesignReport& report) {
  if (!report.result.finding) {
    return {.alarming = true, .remarks = {}};
  }
  const std::string fault = report.built_notch ? "" : notch_sentence(report);
  return {tone_of(report) == Tone::bad, is_too_exact(report), wants_no_friction(report),
          sentence(fault) + remarks(report, report.physical) +
              next_sentence("the structure feels " + felt_words(report, report.physical))};
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
  if (!result.finding) {
    add_emptiness(document, result, task_of(report));
    if (report.catalogue) {
      const design::RatedPart& best = report.catalogue->parts.front();
      if (best.tolerance) {  // it is admissible but for that
        document.verdict = format("No admissible design: no part has {}; the best, {}, has {}.",
                                  tolerance_shown(limits, limits.tolerance), best.part.name,
                                  tolerance_shown(limits, *best.tolerance));
      }
      add_parts(document, *report.catalogue, task_of(report));
    }
    add_task(document, result.request, physical);
    add_region(document, result, problem, limits, physical);
    return document;
  }
  const design::Found& finding = *result.finding;
  document.verdict = verdict(report, physical);
  document.tone = tone_of(report);
  add_answer(document.answer, report, physical);
  add_choices(document, report, physical);
  if (report.built_notch) {
    add_built_notch(document, report, physical);
  }
  add_task(document, result.request, physical);
  add_damper(document.detail("Damper" + with_ideal(report)), finding.point,
             stops_by_delta1(finding.constraints) ? delta_needs(result) : DeltaNeeds(),
             told_practice(task_of(report), finding.practice, finding.point.f, finding.point.delta),
             physical);
  Section& constraints =
      add_constraints(document, finding.constraints, limits, finding.response, physical);
  constraints.heading += with_ideal(report);
  add_feasible(constraints, result, problem, limits, physical);
  add_motion(document, report, physical);
  add_checks(document, finding.cross_check, with_ideal(report), physical);
  if (finding.search) {
    add_search(document, *finding.search, result);
  }
  return document;
}

}  // namespace stillpoint::report
