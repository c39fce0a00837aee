// SPDX-License-Identifier: MIT
#include <stillpoint/design/record_findings.hpp>
#include <stillpoint/report/record_design.hpp>
#include "format.hpp"
#include "json/physical_fields.hpp"
#include "record_design_parts.hpp"
#include "rows.hpp"
#include "sections.hpp"

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

using design::SuiteObjective;

std::string row_name(const design::SuiteFigureKind& kind) {
  return kind.objective == SuiteObjective::acceleration ? "transmitted" : std::string(kind.words);
}

std::string_view combined(design::Combine combine) {
  return combine == design::Combine::max ? "largest" : "mean";
}

bool is_searched(const Interval& range) {
  return range.low < range.high;
}

/// What a reader should know of a spring at an end of what was searched; empty elsewhere.
std::string end_words(const Interval& searched, double p, bool of_period) {
  constexpr double apart = 1e-6;
  if (p <= searched.low * (1 + apart)) {
    return of_period ? ", the longest that was searched" : ", the least that was searched";
  }
  if (p >= searched.high * (1 - apart)) {
    return of_period ? ", the shortest that was searched" : ", the largest that was searched";
  }
  return {};
}

/// With the digits with which its figures come true.
std::string exact_words(const Physical& physical, const design::SuiteDamper& damper) {
  return format("f = {:.{}g}, delta = {}{}", damper.f, printed_digits,
                length_shown(physical, damper.delta, printed_digits),
                damper.width > 0
                    ? format(", {} wide", length_shown(physical, damper.width, printed_digits))
                    : "");
}

void add_answer(Section& answer, const RecordDesignReport& report) {
  const auto& [result, physical] = report;
  const design::SuiteDamper& damper = result.finding->point.damper;
  answer.row("damper", exact_words(physical, damper), Tone::heading);
  if (is_searched(result.request.p)) {
    answer.row("spring", spring_words(physical, damper.p, period_digits(result.request)) +
                             end_words(result.request.p, damper.p, physical.has_value()));
  }
  add_box(answer, result, physical);
  add_rest(answer, result);
  add_worst_of_mean(answer, result, physical);
  const design::SuiteCheck& check = result.finding->check;
  answer.row("check",
             check.passed
                 ? check.relative_error == 0
                       ? "passed: Runge-Kutta agrees exactly"
                       : format("passed: Runge-Kutta agrees to {:.1e}", check.relative_error)
                 : format("FAILED: Runge-Kutta is off by {:.1e}; {:.0e} is allowed",
                          check.relative_error, check.tolerance),
             check.passed ? Tone::good : Tone::bad);
}

void add_damper(Document& document, const RecordDesignReport& report) {
  const Physical& physical = report.physical;
  const design::SuiteDamper& damper = report.result.finding->point.damper;
  Section& section = document.detail("Damper");
  if (physical) {
    add_si_rows(section, damper_fields,
                Si{.input = *physical, .f = damper.f, .delta = damper.delta});
  }
  if (!is_searched(report.result.request.p)) {
    section.row("spring", spring_words(physical, damper.p));
  }
  add_decision_margin(section, report.result);
}

/// What is left of the tolerance within the limits.
std::string tolerance_left(const RecordDesignReport& report) {
  const auto& largest = report.result.largest_tolerance;
  return largest
             ? format("the largest that a damper has within the limits is {:.2g} %", 100 * *largest)
             : "no damper that was tried meets the limits, even if it is exact";
}

void add_shortfalls(Document& document, const RecordDesignReport& report) {
  const Physical& physical = report.physical;
  Section& section = document.section("Limits");
  if (!report.result.nearest.figures.settled) {
    section.line("No damper that was tried comes to rest.", Tone::bad);
    return;
  }
  const design::SuiteDamper& damper = report.result.nearest.damper;
  section.row("nearest",
              format("{}, {}", exact_words(physical, damper),
                     spring_words(physical, damper.p, period_digits(report.result.request))));
  for (const auto& [kind, limit, nearest, record, relaxed] : report.result.shortfalls) {
    const auto [near, allowed] = told_apart(physical, kind->dimension, nearest, limit);
    section.row(row_name(*kind), format("{}; {} is allowed", near, allowed),
                nearest > limit ? Tone::bad : Tone::plain);
    section.row(
        "", relaxed ? format("with {} allowed and the other limits unchanged, there is a damper",
                             told_apart(physical, kind->dimension, *relaxed, limit).first)
            : report.result.search.interrupted
                ? "interrupted before it was known whether changing this limit alone is "
                  "enough"
            : nearest > limit ? "changing this limit alone would not be enough"
                              : "met");
  }
  section.row("tolerance", tolerance_left(report));
}

void add_task(Document& document, const RecordDesignReport& report) {
  const design::RecordDesignRequest& task = report.result.request;
  const Physical& physical = report.physical;
  Section& section = document.detail("Task");
  section.row("objective", task.objective == SuiteObjective::robust
                               ? std::string("the largest tolerance within the limits")
                               : format("minimise the {} {} of the records, the worst within the "
                                        "tolerance",
                                        combined(task.combine.value()), minimised(task).words));
  for (const design::SuiteFigureKind& kind : design::suite_figure_kinds) {
    if (const std::optional<double>& limit = task.limits.*kind.limit) {
      section.row(row_name(kind), "at most " + figure_shown(physical, kind.dimension, *limit));
    }
  }
  if (task.limits.late) {
    section.row("rest",
                format("at the latest {} periods after the end of each record", *task.limits.late));
  }
  add_real_notch(
      section, task.hold,
      task.width && !is_searched(*task.width) ? std::optional(task.width->low) : std::nullopt,
      physical);
  const auto searched = [](const std::string& low, const std::string& high) {
    return low == high ? low : format("{} to {}", low, high);
  };
  section.row("f searched", searched(digits(task.f->low), digits(task.f->high)));
  section.row("delta searched", searched(length_shown(physical, task.delta->low),
                                         length_shown(physical, task.delta->high)));
  if (task.width && is_searched(*task.width)) {
    section.row("width searched", searched(length_shown(physical, task.width->low),
                                           length_shown(physical, task.width->high)));
  }
  if (is_searched(task.p)) {
    const auto period = [&](double p) {
      return format("{:.4g}", 2 * std::numbers::pi / p * physical->scales.time_s);
    };
    section.row(physical ? "period searched" : "p searched",
                physical ? format("{} to {} s", period(task.p.high), period(task.p.low))
                         : format("{} to {}", digits(task.p.low), digits(task.p.high)));
  }
}

void add_search(Document& document, const design::SuiteSearchCost& search) {
  Section& section = document.detail("Search");
  section.row("scan",
              format("{} boxes, {} within the limits", search.scan_points, search.scan_feasible));
  section.row("dampers", format("{} in all", search.evaluations));
  section.row("time", format("{:.3g} s{}", search.wall_time_s,
                             search.interrupted ? ", then interrupted: the best so far" : ""));
}

}  // namespace

std::string of_records(std::size_t count, std::size_t all) {
  return all == 1       ? "the record"
         : count == all ? "every record"
                        : format("{} of {} records", count, all);
}

bool is_exact(const design::SuiteTolerance& of) {
  return of.f.above + of.f.below + of.delta.above + of.delta.below + of.period.above +
             of.period.below ==
         0;
}

design::NotchShape notch_of(const design::RecordDesignRequest& task,
                            const design::SuiteDamper& damper) {
  return damper.delta == 0
             ? design::NotchShape()
             : design::NotchShape{damper.width > 0 ? std::optional(damper.width) : std::nullopt,
                                  task.hold};
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

void add_real_notch(Section& section, const std::optional<double>& hold,
                    const std::optional<double>& width, const Physical& physical) {
  if (hold) {
    section.row("notch", format("lets go at {} above f", acceleration_shown(*hold)));
  }
  if (width) {
    section.row("notch", format("{} wide", length_shown(physical, *width)));
  }
}

SimulationRequest motion_request(const design::RecordDesign& result,
                                 const design::SuiteDamper& damper, std::size_t record) {
  const design::RecordDesignRequest& task = result.request;
  SimulationRequest request;
  request.oscillator = {damper.p, damper.f, damper.delta, task.hold};
  request.start = {0, 0};
  request.surface.notch_width = notch_of(task, damper).width;
  request.excitation = design::scaled(task.records[record]);
  return request;
}

std::size_t worst_record(const design::RecordDesign& result) {
  const std::vector<ForcedResponse>& all = result.finding->responses;
  const auto value = [&](const ForcedResponse& response) {
    return design::suite_figures(response).*minimised(result.request).value;
  };
  constexpr double same = 1 - 1e-9;  // f + hold is felt under every record that frees the mass
  const double most = value(*std::ranges::max_element(all, {}, value));
  const auto peak_of_worst = [&](const ForcedResponse& response) {
    return value(response) >= same * most ? response.peak_amplitude : -1;
  };
  return static_cast<std::size_t>(std::ranges::max_element(all, {}, peak_of_worst) - all.begin());
}

std::optional<int> period_digits(const design::RecordDesignRequest& task) {
  return is_searched(task.p) ? std::optional(printed_digits) : std::nullopt;
}

std::string progress_words(const design::RecordProgress& progress, const Physical& physical) {
  std::string words = format("{} of about {} dampers", progress.evaluations,
                             std::max(progress.expected, progress.evaluations));
  if (!progress.best) {
    return words;
  }
  const design::SuiteFigures& best = progress.best->figures;
  return words + format(", best verified {}, stroke {}, residual {}",
                        acceleration_shown(best.acceleration), length_shown(physical, best.peak),
                        length_shown(physical, best.residual));
}

Document document(const RecordDesignReport& report) {
  const design::RecordDesign& result = report.result;
  Document document;
  document.title = "Damper under records";
  document.verdict = verdict(report);
  if (result.finding) {
    document.tone = Tone::good;
    add_answer(document.answer, report);
    add_records(document, result, report.physical);
    add_outlook(document, result, report.physical);
    add_damper(document, report);
  } else {
    document.tone = Tone::bad;
    add_shortfalls(document, report);
  }
  add_findings(document, result.findings, report.physical);
  add_task(document, report);
  add_search(document, result.search);
  return document;
}

}  // namespace stillpoint::report
