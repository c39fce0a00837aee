// SPDX-License-Identifier: MIT
#include <stillpoint/report/record_design.hpp>
#include "format.hpp"
#include "sections.hpp"

#include <stillpoint/report/digits.hpp>
#include <stillpoint/report/findings.hpp>

#include <algorithm>
#include <cstddef>
#include <optional>
#include <utility>
#include <vector>

namespace stillpoint::report {

namespace {

constexpr int printed_digits = 12;  // of a design: as many as it was rounded to, or almost all

/// In which a period is printed; the usual ones unless it was searched.
std::optional<int> period_digits(const design::RecordDesignRequest& task) {
  return task.p.low < task.p.high ? std::optional(printed_digits) : std::nullopt;
}

/// "0.1991 g transmitted, stroke 307.18 mm, residual 35.709 mm"
std::string figures_words(const design::SuiteFigures& figures, const Physical& physical) {
  return acceleration_shown(figures.acceleration) + " transmitted" +
         (figures.peak == 0 ? ""
                            : format(", stroke {}, residual {}",
                                     figure_shown(physical, Dimension::length, figures.peak),
                                     figure_shown(physical, Dimension::length, figures.residual)));
}

/// "Largest of 3 cases"
std::string whose_words(const std::vector<design::LoadCase>& cases) {
  const design::LoadCase& first = cases.front();
  return cases.size() > 1     ? format("Largest of {} cases", cases.size())
         : first.of_records() ? design::suite_words(*first.combine, first.records.size())
                              : format("Under the {}", first.v0 ? "hit" : "pulse");
}

/// With the digits with which the figures of a design come true.
std::string exact_words(const Physical& physical, const design::SuiteDamper& damper,
                        std::optional<int> digits) {
  return format(
      "f = {:.{}g}, delta = {}{}", damper.f, digits.value_or(6),
      length_shown(physical, damper.delta, digits),
      damper.width > 0 ? format(", {} wide", length_shown(physical, damper.width, digits)) : "");
}

void add_answer(Section& answer, const RecordDesignReport& report) {
  const auto& [result, physical] = report;
  const design::SuitePoint& point = result.finding->point;
  answer.row("damper", exact_words(physical, point.damper, printed_digits), Tone::heading);
  if (const auto digits = period_digits(result.request)) {
    const Interval& searched = result.request.p;
    constexpr double apart = 1e-6;
    const bool at_end = point.damper.p <= searched.low * (1 + apart) ||
                        point.damper.p >= searched.high * (1 - apart);
    answer.row("spring", spring_words(physical, point.damper.p, digits) +
                             (at_end ? ", an end of what was searched" : ""));
  }
  if (result.largest_tolerance) {
    answer.row("tolerance",
               format("{:.3g} %, the largest that was found", 100 * *result.largest_tolerance));
  }
  if (const std::int64_t samples = result.finding->box.samples; samples > 1) {
    answer.row("tried", format("no failure in {} dampers within the tolerance, corners and "
                               "boundary included",
                               samples));
    answer.row("exact", "without any error: " + figures_words(largest(point.figures), physical));
  }
  add_check(answer, result.finding->cross_check);
}

/// "0.31 %", "42 %"
std::string part_words(double part) {
  constexpr double whole = 0.1;
  return part < whole ? format("{:.2g} %", 100 * part) : format("{:.0f} %", 100 * part);
}

/// What governs each case, and under which motion and damper of the box.
void add_cases(Document& document, const design::RecordDesign& result, const Physical& physical) {
  const std::vector<design::LoadCase>& cases = result.request.cases;
  const FigureUnits units = units_of(physical);
  Table table{{"case", "governed by", "slack", "under", "f", in("delta", units.length)}, {}};
  for (std::size_t i = 0; i < cases.size(); ++i) {
    const auto now = design::governing(result, i);
    if (!now) {
      table.rows.push_back({{cases[i].name, "nothing", "", "", "", ""}});
      continue;
    }
    const design::Constraint& limit = now->constraint;
    table.rows.push_back(
        {{cases[i].name, requirement(limit, units), part_words(now->part_left),
          scaled_name(limit.motion->file, limit.motion->scale), format("{:.4g}", now->damper.f),
          format("{:.4g}", now->damper.delta * units.length)},
         limit.satisfied ? Tone::good : Tone::bad});
  }
  document.section("Cases", {std::move(table)});
}

void add_motions(Document& document, const design::RecordDesign& result, const Physical& physical) {
  const FigureUnits units = units_of(physical);
  const auto number = [](double value) { return format("{:.5g}", value); };
  const std::vector<design::LoadCase>& cases = result.request.cases;
  const bool alone = cases.size() == 1;
  const bool shaken = alone && cases.front().of_records();
  Table table{{"case", shaken ? "record" : "motion", "PGA, g", in("peak", units.length),
               in("residual", units.length), "transmitted, g", in("rests from", units.time), ""},
              {}};
  for (std::size_t c = 0; c < cases.size(); ++c) {
    const std::vector<design::CaseMotion> motions = design::motions_of(cases[c]);
    for (std::size_t i = 0; i < motions.size(); ++i) {
      const ForcedResponse& response = result.finding->responses[c][i];
      const auto figures = design::suite_figures(response);
      const bool rests_at_0 = begins_at_nothing(figures.residual, figures.peak);
      table.rows.push_back(
          {{i == 0 ? cases[c].name : "", scaled_name(motions[i].name, motions[i].scale),
            cases[c].v0 ? "" : number(design::peak_load(motions[i].load)),
            number(figures.peak * units.length),
            number(rests_at_0 ? 0 : figures.residual * units.length), number(figures.acceleration),
            alone ? number(*response.stop_time * units.time) : "",
            response.locks() && alone ? "locked" : ""}});
    }
  }
  document.section(shaken ? "Records" : "Motions", {without_empty_columns(std::move(table))})
      .detail = !alone;
}

std::string no_damper(const design::RecordDesign& result, const Physical& physical) {
  const auto& largest = result.largest_tolerance;
  return result.search.interrupted ? "No damper was verified before the search was interrupted."
         : !result.nearest.figures.empty() && !settled(result.nearest.figures)
             ? "No damper was found: none of those tried comes to rest."
             : format("No damper was found that meets the limits{}.{}{}",
                      result.request.tolerance.exact() ? "" : " within its tolerance",
                      largest ? format(" The largest tolerance within the limits is {:.2g} %.",
                                       100 * *largest)
                              : "",
                      one_way_out(result.mends, physical));
}

}  // namespace

std::string scaled_name(std::string_view file, double scale) {
  return (scale == 1 ? "" : format("{:.4g} x ", scale)) +
         spelled_out(file.substr(file.rfind('/') + 1));
}

std::string record_label(const design::SuiteRecord& record) {
  return scaled_name(record.name, record.scale);
}

std::string record_words(std::string_view file, double scale, std::string_view units, bool assumed,
                         double peak) {
  return format("{}, in {}{}, peak {}", scaled_name(file, scale), units,
                assumed ? " (assumed)" : "", acceleration_shown(peak));
}

std::string progress_words(const design::RecordProgress& progress, const Physical& physical) {
  const std::string words = format("{} of about {} dampers", progress.evaluations,
                                   std::max(progress.expected, progress.evaluations));
  return progress.best ? format("{}, best verified {}", words,
                                figures_words(largest(progress.best->figures), physical))
                       : words;
}

std::string verdict(const RecordDesignReport& report) {
  const auto& [result, physical] = report;
  if (!result.finding) {
    return no_damper(result, physical);
  }
  const design::SuiteDamper& damper = result.finding->point.damper;
  return format("{} {}, with {}. {}{}: {}.",
                result.search.interrupted ? "The best damper so far has" : advice(result.findings),
                damper_words(physical, damper.f, damper.delta,
                             {damper.notch_width(), result.request.hold}, printed_digits),
                period_words(physical, damper.p, period_digits(result.request)),
                whose_words(result.request.cases),
                result.finding->box.samples > 1 ? ", worst within the tolerance" : "",
                figures_words(largest(result.finding->box.worst), physical));
}

Document document(const RecordDesignReport& report) {
  const auto& [result, physical] = report;
  Document document = answered("Damper design", report, result.finding ? Tone::good : Tone::bad);
  if (result.finding) {
    add_answer(document.answer, report);
    if (result.request.cases.size() > 1) {
      add_cases(document, result, physical);
    }
    add_motions(document, result, physical);
  } else if (settled(result.nearest.figures)) {
    const design::SuiteDamper& damper = result.nearest.damper;
    document.answer.row("nearest", format("{}, with {}", exact_words(physical, damper, {}),
                                          spring_words(physical, damper.p)));
    if (!result.mends.empty()) {
      add_mends(document, result.mends, physical);
    }
  }
  add_constraints(
      document, result.constraints, physical,
      result.request.tolerance.exact() ? "" : "Each is the worst within the tolerance.");
  add_findings(document, result.findings, physical);
  return document;
}

}  // namespace stillpoint::report
