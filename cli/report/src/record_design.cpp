// SPDX-License-Identifier: MIT
#include <stillpoint/report/record_design.hpp>
#include "format.hpp"
#include "sections.hpp"

#include <stillpoint/design/record_findings.hpp>
#include <stillpoint/report/digits.hpp>
#include <stillpoint/report/findings.hpp>

#include <algorithm>
#include <cstddef>
#include <optional>
#include <utility>

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
    answer.row("spring", spring_words(physical, point.damper.p, digits));
  }
  if (result.largest_tolerance) {
    answer.row("tolerance",
               format("{:.3g} %, the largest that was found", 100 * *result.largest_tolerance));
  }
  if (const std::int64_t samples = result.finding->box.samples; samples > 1) {
    answer.row("tried", format("no failure in {} dampers within the tolerance, corners and "
                               "boundary included",
                               samples));
    answer.row("exact", "without any error: " + figures_words(point.figures, physical));
  }
  add_check(answer, result.finding->cross_check);
}

void add_records(Document& document, const design::RecordDesign& result, const Physical& physical) {
  const FigureUnits units = units_of(physical);
  const auto number = [](double value) { return format("{:.5g}", value); };
  Table table{{"record", "PGA, g", in("peak", units.length), in("residual", units.length),
               "transmitted, g", in("rests from", units.time), ""},
              {}};
  for (std::size_t i = 0; i < result.finding->responses.size(); ++i) {
    const ForcedResponse& response = result.finding->responses[i];
    const auto figures = design::suite_figures(response);
    const bool rests_at_0 = begins_at_nothing(figures.residual, figures.peak);
    const design::SuiteRecord& record = result.request.records[i];
    table.rows.push_back(
        {{record_label(record), number(design::peak_load(record)),
          number(figures.peak * units.length),
          number(rests_at_0 ? 0 : figures.residual * units.length), number(figures.acceleration),
          number(*response.stop_time * units.time), response.locks() ? "locked" : ""}});
  }
  document.section("Records", {without_empty_columns(std::move(table))});
}

std::string no_damper(const design::RecordDesign& result) {
  const auto& largest = result.largest_tolerance;
  return result.search.interrupted ? "No damper was verified before the search was interrupted."
         : !result.nearest.figures.settled
             ? "No damper was found: none of those tried comes to rest."
             : format("No damper was found that meets the limits{}.{}",
                      result.request.tolerance.exact() ? "" : " within its tolerance",
                      largest ? format(" The largest tolerance within the limits is {:.2g} %.",
                                       100 * *largest)
                              : "");
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
                                figures_words(progress.best->figures, physical))
                       : words;
}

std::string verdict(const RecordDesignReport& report) {
  const auto& [result, physical] = report;
  if (!result.finding) {
    return no_damper(result);
  }
  const design::SuiteDamper& damper = result.finding->point.damper;
  return format("{} {}, with {}. {}{}: {}.",
                result.search.interrupted ? "The best damper so far has" : advice(result.findings),
                damper_words(physical, damper.f, damper.delta,
                             {damper.notch_width(), result.request.hold}, printed_digits),
                period_words(physical, damper.p, period_digits(result.request)),
                design::suite_words(*result.request.combine, result.request.records.size()),
                result.finding->box.samples > 1 ? ", worst within the tolerance" : "",
                figures_words(result.finding->box.worst, physical));
}

Document document(const RecordDesignReport& report) {
  const auto& [result, physical] = report;
  Document document = answered("Damper design", report, result.finding ? Tone::good : Tone::bad);
  if (result.finding) {
    add_answer(document.answer, report);
    add_records(document, result, physical);
  } else if (result.nearest.figures.settled) {
    const design::SuiteDamper& damper = result.nearest.damper;
    document.answer.row("nearest", format("{}, {}", exact_words(physical, damper, {}),
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
