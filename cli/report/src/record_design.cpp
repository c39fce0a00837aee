// SPDX-License-Identifier: MIT
#include <stillpoint/report/record_design.hpp>
#include "format.hpp"
#include "sections.hpp"

#include <stillpoint/design/record_findings.hpp>
#include <stillpoint/report/digits.hpp>
#include <stillpoint/report/findings.hpp>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <numbers>
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

/// Whose figures the verdict has: "Worst of 7 records within the tolerance".
std::string whose_words(const design::RecordDesign& result) {
  const std::size_t count = result.request.records.size();
  const bool mean = is_mean(result.request);
  const std::string records =
      count == 1 ? "Under the record" : format("{} of {} records", mean ? "Mean" : "Worst", count);
  return records + (result.finding->box.samples == 1 ? ""
                    : count == 1 || mean             ? ", worst within the tolerance"
                                                     : " within the tolerance");
}

/// With the digits with which its figures come true.
std::string exact_words(const Physical& physical, const design::SuiteDamper& damper) {
  return format("f = {:.{}g}, delta = {}{}", damper.f, printed_digits,
                length_shown(physical, damper.delta, printed_digits),
                damper.width > 0
                    ? format(", {} wide", length_shown(physical, damper.width, printed_digits))
                    : "");
}

/// "f 0.0588 to 0.0719, delta 1 mm to 1.2 mm": the sides of a box, without those that are exact.
std::string sides_words(const design::SuiteBox& box, const Physical& physical) {
  std::string text;
  const auto add = [&](std::string_view name, const Interval& range, const auto& words) {
    if (range.low < range.high) {
      text += format("{}{} {} to {}", text.empty() ? "" : ", ", name, words(range.low),
                     words(range.high));
    }
  };
  const auto number = [](double value) { return format("{:.4g}", value); };
  const auto length = [&](double value) { return length_shown(physical, value, 4); };
  const auto seconds = [&](double turn) { return time_shown(physical, turn); };
  add("f", box.f, number);
  add("delta", box.delta, length);
  add("width", box.width, length);
  if (physical) {
    add("period", {2 * std::numbers::pi / box.p.high, 2 * std::numbers::pi / box.p.low}, seconds);
  } else {
    add("p", box.p, number);
  }
  return text;
}

/// What was tried about the damper, and what it does itself.
void add_box(Section& answer, const design::RecordDesign& result, const Physical& physical) {
  const design::SuiteBox& box = result.finding->box;
  const std::string sides = sides_words(box, physical);
  if (sides.empty()) {
    return;
  }
  if (result.largest_tolerance) {
    answer.row("tolerance",
               format("{:.3g} %, the largest that was found", 100 * *result.largest_tolerance));
  }
  answer.row("tried", format("{}: no failure in {} dampers, corners and boundary included", sides,
                             box.samples));
  answer.row("exact", format("without any error: {}",
                             figures_words(result.finding->point.figures, physical)));
}

void add_answer(Section& answer, const RecordDesignReport& report) {
  const auto& [result, physical] = report;
  const design::SuiteDamper& damper = result.finding->point.damper;
  const Interval& searched = result.request.p;
  answer.row("damper", exact_words(physical, damper), Tone::heading);
  if (searched.low < searched.high) {
    constexpr double apart = 1e-6;
    const bool at_end =
        damper.p <= searched.low * (1 + apart) || damper.p >= searched.high * (1 - apart);
    answer.row("spring", spring_words(physical, damper.p, printed_digits) +
                             (at_end ? ", an end of what was searched" : ""));
  }
  add_box(answer, result, physical);
  add_check(answer, result.finding->cross_check);
}

/// From when on the load is 0.
double load_end(Record record) {
  auto& [values, step, times] = record;
  while (values.size() > 1 && values.back() == 0 && values[values.size() - 2] == 0) {
    values.pop_back();
  }
  times.resize(times.empty() ? 0 : values.size());
  return duration(Excitation(record)).value();
}

/// In the unit of the figures.
std::string displacement_cell(const Physical& physical, double length) {
  const FigureUnits units = units_of(physical);
  constexpr double least_m = 1e-6;
  return physical && length > 0 && length * physical->scales.length_m < least_m
             ? format("<{:g}", least_m / physical->scales.length_m * units.length)
             : format("{:.5g}", length * units.length);
}

void add_records(Document& document, const design::RecordDesign& result, const Physical& physical) {
  const FigureUnits units = units_of(physical);
  Table table{{"record", "PGA, g", in("peak", units.length), in("residual", units.length),
               "transmitted, g", in("rests from", units.time), "at rest"},
              {}};
  for (std::size_t i = 0; i < result.finding->responses.size(); ++i) {
    const ForcedResponse& response = result.finding->responses[i];
    const design::SuiteFigures figures = design::suite_figures(response);
    const design::SuiteRecord& record = result.request.records[i];
    table.rows.push_back(
        {{record_label(record), format("{:.4g}", design::peak_load(record)),
          displacement_cell(physical, figures.peak), displacement_cell(physical, figures.residual),
          format("{:.4g}", figures.acceleration),
          format("{:.5g}", *response.stop_time * units.time),
          response.locks()                                        ? "by notch"
          : response.stop_time.value() <= load_end(record.record) ? "by friction"
                                                                  : "after load"}});
  }
  document.section("Records", std::move(table));
}

/// How far the nearest damper is from the limit that it exceeds most.
std::string shortfall_words(const RecordDesignReport& report) {
  const auto excess = [](const design::Constraint& now) {
    return now.value <= now.limit ? 0 : now.limit > 0 ? now.value / now.limit : HUGE_VAL;
  };
  const auto& all = report.result.constraints;
  const auto most = std::ranges::max_element(all, {}, excess);
  if (most == all.end() || excess(*most) == 0) {
    return {};
  }
  const auto* const kind = std::ranges::find(design::suite_figure_kinds, most->name,
                                             &design::SuiteFigureKind::constraint);
  return format("; the nearest has a {} of {}{}", kind->words,
                beyond(report.physical, kind->dimension, most->value, most->limit),
                report.result.request.records.size() == 1
                    ? ""
                    : ", most under " + scaled_name(most->motion->file, most->motion->scale));
}

std::string no_damper(const RecordDesignReport& report) {
  const design::RecordDesign& result = report.result;
  if (result.search.interrupted) {
    return "No damper was verified before the search was interrupted.";
  }
  if (!result.nearest.figures.settled) {
    return "No damper was found: none of those tried comes to rest.";
  }
  const auto& largest = result.largest_tolerance;
  return format(
      "No damper was found that meets the limits{}{}.{}",
      result.request.tolerance.exact() ? "" : " within its tolerance", shortfall_words(report),
      largest ? format(" The largest tolerance within the limits is {:.2g} %.", 100 * *largest)
              : "");
}

}  // namespace

std::string of_records(std::int64_t count, std::int64_t all) {
  return all == 1       ? "the record"
         : count == all ? "every record"
                        : format("{} of {} records", count, all);
}

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
    return no_damper(report);
  }
  const design::SuiteDamper& damper = result.finding->point.damper;
  return format("{} {}, with {}. {}: {}.",
                result.search.interrupted     ? "The best damper so far has"
                : is_useless(result.findings) ? "The damper found has"
                                              : "Build",
                damper_words(physical, damper.f, damper.delta,
                             {damper.notch_width(), result.request.hold}, printed_digits),
                period_words(physical, damper.p, period_digits(result.request)),
                whose_words(result), figures_words(result.finding->box.worst, physical));
}

Document document(const RecordDesignReport& report) {
  const auto& [result, physical] = report;
  Document document = answered("Damper design", report, result.finding ? Tone::good : Tone::bad);
  if (result.finding) {
    add_answer(document.answer, report);
    add_records(document, result, physical);
  } else if (result.nearest.figures.settled) {
    const design::SuiteDamper& damper = result.nearest.damper;
    document.answer.row("nearest",
                        format("{}, {}", exact_words(physical, damper),
                               spring_words(physical, damper.p, period_digits(result.request))));
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
