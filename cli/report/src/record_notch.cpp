// SPDX-License-Identifier: MIT
// What a notch with a width does to a design under records with the paper's notch.
#include "format.hpp"
#include "record_design_parts.hpp"

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
  return damper.delta > 0 && figures.peak > 0 && !result.request.notch_width &&
         !result.request.hold;
}

/// What a notch of the example width spoils; empty if nothing. Accelerations apart: those of this
/// design are those between passages.
std::string example_fault(const design::RecordDesign& result, double width,
                          const Physical& physical) {
  const design::RecordFinding& finding = *result.finding;
  const auto wide = [&](std::vector<design::SuiteRecord> records) {
    return design::figures_with_width(result.request, std::move(records), finding.point.damper,
                                      width);
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
    return format("the mass never leaves it under {}", of_records(inside, records.size()));
  }
  const design::SuiteFigures all = wide(records);
  if (!all.settled) {
    return "the mass may never rest";
  }
  for (const design::SuiteFigureKind& kind : design::suite_figure_kinds) {
    const std::optional<double>& limit = result.request.limits.*kind.limit;
    const double value = all.*kind.value;
    if (limit && kind.objective != design::SuiteObjective::acceleration && value > *limit) {
      return format("the {} is {}, where {} is allowed", kind.words,
                    figure_shown(physical, kind.objective, value),
                    figure_shown(physical, kind.objective, *limit));
    }
  }
  return {};
}

}  // namespace

std::string example_sentence(const design::RecordDesign& result, const Physical& physical) {
  if (!has_ideal_notch(result)) {
    return {};
  }
  const auto& [damper, figures] = result.finding->point;
  const double width = example_width(physical, figures.peak);
  const std::string fault =
      can_be_followed(width, damper.delta, damper.p) ? example_fault(result, width, physical) : "";
  return fault.empty() ? ""
                       : example_sentence("that acts only after the start", width, fault, physical);
}

void add_example(Section& answer, const design::RecordDesign& result, const Physical& physical) {
  if (!has_ideal_notch(result)) {
    return;
  }
  const auto& [damper, figures] = result.finding->point;
  double weakest = HUGE_VAL;
  double strongest = 0;
  for (const design::SuiteRecord& record : result.request.records) {
    weakest = std::min(weakest, design::peak_load(record));
    strongest = std::max(strongest, design::peak_load(record));
  }
  answer.row("in the notch",
             inside_words(physical, {damper.p, damper.f, damper.delta}, figures.peak, strongest));
  const StartUnderLoad start{damper.f, damper.delta, weakest};
  add_start(answer, start, "delta/(load - f), under the weakest record",
            start.width() > figures.peak, physical);
}

}  // namespace stillpoint::report
