// SPDX-License-Identifier: MIT
#include "choices.hpp"

#include <stillpoint/report/findings.hpp>

namespace stillpoint::report {

namespace {

/// "The damper is admissible: f and delta may both be off by +-33.86 %.", or what is wrong.
std::string judgement(const RegionReport& report) {
  const design::RegionAnswer& answer = report.answer;
  const design::Limits& limits = report.request.limits;
  const std::string wrong = broken(answer.constraints, report.physical);
  const std::string why =
      answer.tolerance ? tolerance_words(design::Limits{}, *answer.tolerance, *report.request.delta)
      : wrong.empty()  ? "some hits of the range leave it too far off centre"
                       : wrong;
  return format("The damper is {}{}: {}.", *answer.admissible ? "admissible" : "not admissible",
                answer.tolerance && !*answer.admissible
                    ? format(" with a tolerance of {}", tolerance_text(limits, limits.tolerance))
                    : "",
                why);
}

bool fits(const Catalogue& catalogue) {
  return std::ranges::any_of(catalogue.parts, &design::RatedPart::admissible);
}

/// Of several arrivals.
void add_strips(Document& document, const design::Problem& problem,
                const std::vector<design::Strip>& strips) {
  constexpr std::size_t most_listed = 10;
  if ((problem.arrivals == 1 && !problem.residual) || strips.empty()) {
    return;
  }
  Table table{{"arrival", "feasible f", "largest tolerance"}, {}};
  for (const design::Strip& strip : std::span(strips).first(std::min(most_listed, strips.size()))) {
    table.rows.push_back(
        {{strip.arrival == 0 ? "none, within the residual" : format("{}", strip.arrival),
          strip.f_lower ? interval_digits(*strip.f_lower, *strip.f_upper, digits_of_region)
                        : "none with the tolerance asked for",
          "+-" + percent_digits(strip.tolerance)}});
  }
  document.section("Dampers that stop at each arrival", {std::move(table)})
      .line(strips.size() > most_listed ? "--json lists the later ones." : "", Tone::faint);
}

}  // namespace

std::string verdict(const RegionReport& report) {
  const design::RegionAnswer& answer = report.answer;
  const std::size_t intervals = answer.intervals ? answer.intervals->size() : 1;
  return report.request.delta ? judgement(report)
         : !answer.region.feasible
             ? none_admissible(answer, task_of(report))
             : format("Feasible f{}: {}{}.{}",
                      report.request.limits.tolerance > 0 ? " with the tolerance asked for" : "",
                      feasible_words(report.answer.feasible_f),
                      intervals > 1
                          ? format("; of {} intervals this one has the most tolerant damper",
                                   intervals)
                          : "",
                      report.catalogue && !fits(*report.catalogue)
                          ? " None of the parts of the catalogue is admissible."
                          : "");
}

Document document(const RegionReport& report) {
  const auto& [problem, limits, f, delta, pulse, ranges] = report.request;
  const design::RegionAnswer& answer = report.answer;
  const design::Region& region = answer.region;
  const Physical& physical = report.physical;
  const ShownTask task = task_of(report);
  Document document =
      answered("Admissible region", report,
               answer.admissible.value_or(region.feasible) ? Tone::good : Tone::bad);
  Section& rows = document.answer;
  const std::string_view asked = limits.tolerance > 0 ? ", with the tolerance asked for" : "";
  if (f) {
    rows.row("damper",
             format("f = {:.9g}{}{}", *f, force_beside(physical, *f),
                    delta ? ", delta = " + length_shown(physical, *delta) : ""),
             Tone::heading);
  }
  if (delta) {
    rows.row("feasible f", (region.feasible ? feasible_words(report.answer.feasible_f) : "none") +
                               std::string(asked));
  }
  if (const auto& feasible = answer.feasible_delta;
      feasible && (f || !feasible->empty()) && (region.feasible || !delta)) {
    rows.row("feasible delta",
             format("{} at {}{}", feasible->empty() ? "none" : delta_words(*feasible, physical),
                    f ? "this f" : "every feasible f", asked));
  }
  if (f && (!delta || stops_by_delta1(answer.constraints))) {
    rows.row("delta needed",
             answer.delta1_exact
                 ? format("{} by the published criterion, {} by the exact one",
                          length_limit(physical, answer.delta1_published.value(), true),
                          length_limit(physical, *answer.delta1_exact, true))
                 : "none is enough: the motion does not return");
  }
  if (f && delta && answer.tolerance) {
    add_buildable(rows, physical, {*f, *delta, *answer.tolerance}, limits);
  }
  if (region.conflict != design::Conflict::no_arrival) {  // where no stroke helps
    constexpr int digits_of_tables = 7;  // which round: a stroke must not be below the least
    rows.row(physical ? "least stroke" : "least beta",
             region.beta_min == 0
                 ? "as small as you like: with f just below the peak load the mass hardly moves"
                 : length_limit(physical, region.beta_min, true, digits_of_tables));
  }
  if (answer.response && moves(*answer.response)) {
    add_motion(rows, shown_damper(report.request, answer), physical);
    add_works_for(rows, answer.works_for, physical);
  }
  add_strips(document, problem, answer.strips);
  if (!region.feasible) {
    add_mends(document, answer, task);
  }
  if (report.catalogue) {
    add_parts(document, report.catalogue->parts, report.physical, task.limits);
  }
  if (delta) {
    add_constraints(document, answer.constraints, physical, of_first_swing(task));
  }
  add_findings(document, report.findings, physical);
  return document;
}

}  // namespace stillpoint::report
