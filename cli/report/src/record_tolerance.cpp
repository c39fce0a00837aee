// SPDX-License-Identifier: MIT
// What a damper for records does if it is not built exactly.
#include "format.hpp"
#include "record_design_parts.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

namespace stillpoint::report {

std::string samples_words(const design::Sensitivity& near) {
  return near.admissible == near.samples
             ? format("{0} of {0} samples meet the limits", near.samples)
             : format("{} of {} samples fail{}", near.samples - near.admissible, near.samples,
                      near.samples - near.admissible == 1 ? "s" : "");
}

void add_decision_margin(Section& section, const design::RecordDesign& result) {
  const std::vector<ForcedResponse>& all = result.finding->responses;
  const auto margin = [](const ForcedResponse& response) {
    return response.decision_margin.value_or(HUGE_VAL);
  };
  const auto nearest = std::ranges::min_element(all, {}, margin);
  if (nearest->decision_margin) {
    const auto index = static_cast<std::size_t>(nearest - all.begin());
    section.row(
        "decision margin",
        format("{:.2g} %{}: {}", 100 * *nearest->decision_margin,
               all.size() == 1 ? "" : ", under " + record_label(result.request.records[index]),
               closest_decision()));
  }
}

std::string change_words(double change) {
  constexpr double least = 1e-5;
  return change < least ? "less than 0.001 %" : format("{:.2g} %", 100 * change);
}

bool is_mean(const design::RecordDesignRequest& task) {
  return task.combine.value() == design::Combine::mean && task.records.size() > 1;
}

std::string worst_words(const design::RecordDesign& result, const design::SuiteFigures& worst,
                        const Physical& physical) {
  constexpr int digits = 3;  // of a damper that is some per cent off
  return worst.settled ? format("{}{:.{}g} g, stroke {}, residual {}",
                                is_mean(result.request) ? "a mean of " : "", worst.acceleration,
                                digits, displacement_shown(physical, worst.peak, digits),
                                displacement_shown(physical, worst.residual, digits))
                       : "no rest within 10 000 half-cycles";
}

std::string_view inexact_parts(const design::RecordDesign& result) {
  const design::SuiteDamper& damper = result.finding->point.damper;
  return damper.delta == 0 ? "f" : damper.f == 0 ? "delta" : "f and delta";
}

bool is_delicate(const design::RecordDesign& result) {
  const design::Sensitivity& near = result.finding->sensitivity;
  return 4 * near.admissible < 3 * near.samples || near.much_worse ||
         is_much_worse(near.worst, result.finding->point, result.request);
}

void add_tolerance(Section& answer, const design::RecordDesign& result, const Physical& physical) {
  const design::Sensitivity& near = result.finding->sensitivity;
  if (near.tolerance > 0) {
    answer.row(
        "tolerance",
        format("{} off by up to {:.3g} %: {}; {}", inexact_parts(result), 100 * near.tolerance,
               worst_words(result, near.worst, physical), samples_words(near)),
        near.admissible < near.samples || is_delicate(result) ? Tone::bad : Tone::plain);
  }
  if (near.much_worse) {
    answer.row("much worse",
               format("off by {}: {}", change_words(near.much_worse->change),
                      worst_words(result, near.much_worse->figures, physical)),
               Tone::bad);
  }
}

}  // namespace stillpoint::report
