// SPDX-License-Identifier: MIT
// What a mass feels in the notch of a design under records, and what a width changes.
#include "format.hpp"
#include "record_design_parts.hpp"

#include <stillpoint/report/record_design.hpp>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <utility>
#include <vector>

namespace stillpoint::report {

namespace {

/// The paper's notch, for which another stands in the answer.
bool has_ideal_notch(const design::RecordDesign& result) {
  const auto& [damper, figures] = result.finding->point;
  return damper.delta > 0 && !hardly_moves(result) && !result.request.notch_width &&
         !result.request.hold;
}

/// Under which records the mass moves in the design, but would be held by any notch with a width
/// and transmit more than is promised.
std::optional<RealNotchFault> fault_of_any(const design::RecordDesign& result,
                                           const Physical& physical) {
  const auto& [damper, combined] = result.finding->point;
  const std::vector<design::SuiteRecord>& records = result.request.records;
  std::size_t count = 0;
  std::optional<std::pair<StartUnderLoad, std::size_t>> weakest;
  for (std::size_t i = 0; i < records.size(); ++i) {
    const design::SuiteFigures own = design::suite_figures(result.finding->responses[i]);
    const StartUnderLoad start{damper.f, damper.delta, design::peak_load(records[i])};
    if (start.width() >= 2 * own.peak && !hardly_moves(damper.p, own.peak, start.load) &&
        start.load > (is_mean(result.request) ? own : combined).acceleration) {
      ++count;
      if (!weakest || start.load < weakest->first.load) {
        weakest.emplace(start, i);
      }
    }
  }
  if (!weakest) {
    return {};
  }
  const bool one = records.size() == 1;
  const std::string under =
      " under " + (count == records.size() ? "any record" : of_records(count, records.size()));
  return RealNotchFault{
      true, "No notch works" + (one ? "" : under),
      no_notch_words(weakest->first, result.finding->responses[weakest->second].peak_amplitude,
                     one ? "" : under, one ? "the record" : record_label(records[weakest->second]),
                     physical)};
}

/// What a notch of that width spoils; empty if nothing. Accelerations apart: those of this design
/// are those between passages.
std::string fault_of_width(const design::RecordDesign& result, double width,
                           const Physical& physical) {
  const design::RecordFinding& finding = *result.finding;
  const auto wide = [&](std::vector<design::SuiteRecord> records) {
    design::RecordDesignRequest request = result.request;
    request.records = std::move(records);
    request.notch_width = width;
    return design::figures_of(request, finding.point.damper);
  };
  const std::vector<design::SuiteRecord>& records = result.request.records;
  std::size_t inside = 0;
  for (std::size_t i = 0; i < records.size(); ++i) {
    const bool leaves = finding.responses[i].peak_amplitude > width / 2;
    if (leaves && wide({records[i]}).peak <= width / 2) {
      ++inside;
    }
  }
  if (inside > 0) {
    return format("the mass never leaves it under {}", inside == records.size() && inside > 1
                                                           ? "any record"
                                                           : of_records(inside, records.size()));
  }
  const design::SuiteFigures all = wide(records);
  if (!all.settled) {
    return "the mass may never rest";
  }
  for (const design::SuiteFigureKind& kind : design::suite_figure_kinds) {
    const std::optional<double>& limit = result.request.limits.*kind.limit;
    const double value = all.*kind.value;
    if (limit && kind.objective != design::SuiteObjective::acceleration &&
        value > *limit * for_rounding) {
      const auto [is, allowed] = told_apart(physical, kind.objective, value, *limit);
      return format("the {} is {}, where {} is allowed", kind.words, is, allowed);
    }
  }
  return {};
}

/// "impulses of up to 1.21 MN s (a.txt)": the largest of all records, and of which; empty if the
/// mass never comes back to x = 0.
std::string impulse_words(const design::RecordDesign& result, const Physical& physical) {
  const auto [speed, record] = largest_jump(result);
  const auto& records = result.request.records;
  return speed == 0 ? ""
                    : format("impulses of up to {}{}", impulse_shown(physical, speed),
                             records.size() == 1 ? "" : " (" + record_label(records[record]) + ")");
}

StartUnderLoad under_the_weakest(const design::RecordDesign& result) {
  const design::SuiteDamper& damper = result.finding->point.damper;
  double weakest = HUGE_VAL;
  for (const design::SuiteRecord& record : result.request.records) {
    weakest = std::min(weakest, design::peak_load(record));
  }
  return {damper.f, damper.delta, weakest};
}

}  // namespace

VelocityJump largest_jump(const design::RecordDesign& result) {
  const std::vector<ForcedResponse>& all = result.finding->responses;
  const auto most = std::ranges::max_element(all, {}, &ForcedResponse::jump);
  return {hardly_moves(result) ? 0 : most->jump, static_cast<std::size_t>(most - all.begin())};
}

std::optional<RealNotchFault> real_notch_fault(const design::RecordDesign& result,
                                               const Physical& physical) {
  if (!has_ideal_notch(result)) {
    return {};
  }
  if (auto none = fault_of_any(result, physical)) {
    return none;
  }
  const auto& [damper, figures] = result.finding->point;
  const double width = example_width(physical, figures.peak);
  const std::string words =
      can_be_followed(width, damper.delta, damper.p) ? fault_of_width(result, width, physical) : "";
  if (words.empty()) {
    return {};
  }
  const std::string wide = length_shown(physical, width) + " wide";
  return RealNotchFault{
      false, "Not for a notch " + wide,
      format("with one {}, {}{}", wide, words,
             under_the_weakest(result).width() < 2 * figures.peak
                 ? format("; try others with --notch-width{}", physical ? "-m" : "")
                 : "")};
}

void add_notch(Section& answer, const RecordDesignReport& report) {
  const auto& [result, physical, fault] = report;
  const auto& [damper, figures] = result.finding->point;
  if (damper.delta == 0 || hardly_moves(result) || result.request.notch_width) {
    return;
  }
  const std::string impulse = impulse_words(result, physical);
  if (!impulse.empty()) {
    answer.row("in the notch", impulse);
  }
  if (!has_ideal_notch(result)) {
    return;
  }
  const double strongest = design::peak_load(result.request.records);
  if (fault) {
    answer.row("real notch", fault->words, Tone::bad);
  } else {
    answer.row(impulse.empty() ? "in the notch" : "",
               inside_words(physical, {damper.p, damper.f, damper.delta}, figures.peak, strongest));
  }
  if (!fault || !fault->of_any) {
    add_start(answer, under_the_weakest(result),
              result.request.records.size() == 1 ? "delta/(load - f)"
                                                 : "delta/(load - f), under the weakest record",
              false, physical);
  }
}

}  // namespace stillpoint::report
