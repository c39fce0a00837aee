// SPDX-License-Identifier: MIT
// The headline of a design under records: what to build, and the worst that it does within its
// tolerance. The rest is in the rows below it.
#include "format.hpp"
#include "record_design_parts.hpp"
#include "sentence.hpp"

#include <stillpoint/report/record_design.hpp>

#include <algorithm>
#include <cstddef>
#include <optional>
#include <string>
#include <string_view>

namespace stillpoint::report {

namespace {

using design::SuiteFigures;

/// "Within its tolerance, the mean (largest stroke of one record 412 mm) of 7 records: ..."
std::string does_words(const design::RecordDesign& result, const Physical& physical) {
  const std::size_t count = result.request.records.size();
  double most = 0;
  for (const ForcedResponse& response : result.finding->responses) {
    most = std::max(most, response.peak_amplitude);
  }
  const design::SuiteBox& box = result.finding->box;
  const std::string tried = samples_words(box);
  return format(
      "{}{}: {}{}{}",
      is_mean(result.request) ? format("Mean of {} records", count)
                              : design::suite_words(*result.request.combine, count),
      tried.empty() ? "" : ", the worst within the tolerance", figures_words(box.worst, physical),
      is_mean(result.request)
          ? format(" (the largest stroke of one record: {})", displacement_shown(physical, most))
          : "",
      tried.empty() ? "" : "; " + tried);
}

/// Empty if the mass moves.
std::string stands_still(const design::RecordDesign& result) {
  const std::size_t all = result.finding->responses.size();
  return result.finding->point.figures.peak > 0
             ? isolates(result) ? ""
                                : "This damper isolates nothing: the mass feels more than 95 % of "
                                  "the largest load. "
             : format("The mass never moves: it is held through {}. ", of_records(all, all));
}

/// " Locked in the notch to the end of the record; ..."; empty if it does not lock or never moves.
std::string lock_caveat(const design::RecordDesign& result) {
  return result.finding->point.figures.peak == 0 ? "" : next_sentence(lock_words(result));
}

}  // namespace

std::string record_verdict(const RecordDesignReport& report) {
  const design::RecordDesign& result = report.result;
  const bool interrupted = result.search.interrupted;
  if (!result.finding) {
    return (interrupted ? "Interrupted. " : "") + shortfall_sentence(report);
  }
  const Physical& physical = report.physical;
  const design::SuiteDamper& damper = result.finding->point.damper;
  const std::string still = stands_still(result);
  return (interrupted ? "Interrupted: the best so far. " : "") + still +
         format("{} {}, with {}. {}.{}{}", still.empty() ? "Build" : "The damper found has",
                damper_words(physical, damper.f, damper.delta, notch_of(result.request, damper),
                             printed_digits),
                period_words(physical, damper.p, period_digits(result.request)),
                does_words(result, physical), lock_caveat(result),
                result.finding->check.passed
                    ? ""
                    : " But the check DISAGREES: do not rely on this design.");
}

}  // namespace stillpoint::report
