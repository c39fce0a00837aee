// SPDX-License-Identifier: MIT
#include "choices.hpp"

#include <stillpoint/report/findings.hpp>

namespace stillpoint::report {

namespace {

constexpr int digits_of_f = 6;

/// "up to 0.0043 or 0.0106 to 0.0236"
std::string feasible_words(const RegionReport& report) {
  std::string words;
  for (const auto& [low, high] : report.answer.feasible_f) {
    words += (words.empty() ? "" : " or ") + interval_digits(low, high, digits_of_f);
  }
  return words;
}

/// "The damper is admissible: f and delta may both be off by +-33.86 %.", or what is wrong.
std::string judgement(const RegionReport& report) {
  const design::RegionAnswer& answer = report.answer;
  const design::Limits& limits = report.request.limits;
  const std::string wrong = violations(answer.constraints, task_of(report));
  const std::string why =
      answer.tolerance ? tolerance_words(design::Limits{}, *answer.tolerance, *report.request.delta)
      : wrong.empty()  ? "some hits of the range leave it too far off centre"
                       : "it " + wrong;
  return format("The damper is {}{}: {}.", *answer.admissible ? "admissible" : "not admissible",
                answer.tolerance && !*answer.admissible
                    ? format(" with a tolerance of {}", tolerance_text(limits, limits.tolerance))
                    : "",
                why);
}

/// "2.1 mm to 8.2 mm or 9 mm to 10 mm"; of many the largest.
std::string delta_words(const std::vector<Interval>& all, const Physical& physical) {
  constexpr std::size_t most_listed = 3;
  constexpr double conversion = 1 + 1e-12;  // the rounding of 3 mm to dimensionless and back
  const std::size_t left_out = all.size() - std::min(all.size(), most_listed);
  std::string text;
  for (const auto& [low, high] : std::span(all).subspan(left_out)) {
    const std::string least = length_limit(physical, low, true);
    const std::string most = length_limit(physical, high * conversion, false);
    text += format("{}{}", text.empty() ? "" : " or ",
                   std::isinf(high) ? "at least " + least
                   : low > 0        ? format("{} to {}", least, most)
                                    : "up to " + most);
  }
  return text + (left_out > 0 ? " or in lower ranges" : "");
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
          strip.f_lower ? interval_digits(*strip.f_lower, *strip.f_upper, digits_of_f)
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
                      feasible_words(report),
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
    rows.row("feasible f",
             (region.feasible ? feasible_words(report) : "none") + std::string(asked));
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
    add_parts(document, *report.catalogue, task);
  }
  if (delta) {
    add_constraints(document, answer.constraints, physical, of_first_swing(task));
  }
  add_findings(document, report.findings, physical);
  return document;
}

}  // namespace stillpoint::report
