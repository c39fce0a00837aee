// SPDX-License-Identifier: MIT
// The headline of a design under records: what to build, and the worst that it does within its
// tolerance; or what is in the way.
#include "format.hpp"
#include "record_design_parts.hpp"

#include <stillpoint/design/record_findings.hpp>
#include <stillpoint/report/record_design.hpp>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <string>

namespace stillpoint::report {

namespace {

/// "Mean of 7 records, worst within the tolerance: 0.1991 g transmitted, stroke 307 mm, ..."
std::string does_words(const design::RecordDesign& result, const Physical& physical) {
  const std::size_t count = result.request.records.size();
  const bool exact = result.finding->box.samples == 1;
  const design::SuiteFigures& worst = result.finding->box.worst;
  return format(
      "{}: {} transmitted{}",
      count == 1 ? exact ? "Under the record" : "Under the record, worst within the tolerance"
      : is_mean(result.request)
          ? format("Mean of {} records{}", count, exact ? "" : ", worst within the tolerance")
          : format("Worst of {} records{}", count, exact ? "" : " within the tolerance"),
      acceleration_shown(worst.acceleration),
      worst.peak == 0 ? ""
                      : format(", stroke {}, residual {}", displacement_shown(physical, worst.peak),
                               displacement_shown(physical, worst.residual)));
}

/// How far the nearest damper is from the limit that it exceeds most.
std::string shortfall_words(const RecordDesignReport& report) {
  const design::RecordDesign& result = report.result;
  const auto excess = [](const design::SuiteShortfall& now) {
    return now.nearest <= now.limit ? 0 : now.limit > 0 ? now.nearest / now.limit : HUGE_VAL;
  };
  const auto most = std::ranges::max_element(result.shortfalls, {}, excess);
  if (most == result.shortfalls.end() || most->nearest <= most->limit) {
    return {};
  }
  const auto& [kind, limit, nearest, record, relaxed] = *most;
  return format("; the nearest has a {} of {}{}", kind->words,
                beyond(report.physical, kind->dimension, nearest, limit),
                result.request.records.size() == 1
                    ? ""
                    : ", most under " + record_label(result.request.records[record]));
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
      is_exact(result.request.tolerance) ? "" : " within its tolerance", shortfall_words(report),
      largest ? format(" The largest tolerance within the limits is {:.2g} %.", 100 * *largest)
              : "");
}

}  // namespace

std::string verdict(const RecordDesignReport& report) {
  const design::RecordDesign& result = report.result;
  if (!result.finding) {
    return no_damper(report);
  }
  const Physical& physical = report.physical;
  const design::SuiteDamper& damper = result.finding->point.damper;
  const bool useless = std::ranges::any_of(result.findings, [](const design::Finding& now) {
    return now.severity == design::Severity::fault;
  });
  return format("{} {}, with {}. {}.",
                result.search.interrupted ? "The best damper so far has"
                : useless                 ? "The damper found has"
                                          : "Build",
                damper_words(physical, damper.f, damper.delta, notch_of(result.request, damper),
                             printed_digits),
                period_words(physical, damper.p, period_digits(result.request)),
                does_words(result, physical));
}

}  // namespace stillpoint::report
