// SPDX-License-Identifier: MIT
// What the box of the tolerance of a damper for records does.
#include "format.hpp"
#include "record_design_parts.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <numbers>
#include <string>
#include <string_view>
#include <vector>

namespace stillpoint::report {

namespace {

/// "f 0.0588 to 0.0719", or nothing if it cannot be off.
template <class Words>
void add_side(std::string& text, std::string_view name, const Interval& range, const Words& words) {
  if (range.low < range.high) {
    text += format("{}{} {} to {}", text.empty() ? "" : ", ", name, words(range.low),
                   words(range.high));
  }
}

std::string sides_words(const design::SuiteBox& box, const Physical& physical) {
  const auto length = [&](double value) { return length_shown(physical, value, 4); };
  const auto number = [](double value) { return format("{:.4g}", value); };
  std::string text;
  add_side(text, "f", box.f, number);
  add_side(text, "delta", box.delta, length);
  add_side(text, "width", box.width, length);
  if (physical) {
    const auto period = [&](double p) {
      return 2 * std::numbers::pi / p * physical->scales.time_s;
    };
    add_side(text, "period", {period(box.p.high), period(box.p.low)},
             [](double seconds) { return format("{:.4g} s", seconds); });
  } else {
    add_side(text, "p", box.p, number);
  }
  return text;
}

}  // namespace

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
        format("{:.2g} %{}", 100 * *nearest->decision_margin,
               all.size() == 1 ? "" : ", under " + record_label(result.request.records[index])));
  }
}

std::string figures_words(const design::SuiteFigures& figures, const Physical& physical) {
  return format("{} transmitted{}{}", acceleration_shown(figures.acceleration),
                between_jumps(physical, figures.jump),
                figures.peak == 0
                    ? ""
                    : format(", stroke {}, residual {}", displacement_shown(physical, figures.peak),
                             displacement_shown(physical, figures.residual)));
}

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

void add_outlook(Document& document, const design::RecordDesign& result, const Physical& physical) {
  const design::SuiteOutlook& outlook = result.finding->outlook;
  Section& section =
      document.detail(format("Not required: off by {:.0f} %", 100 * design::SuiteOutlook::off));
  const auto words = [&](const design::SuiteFigures& worst) {
    return worst.settled ? figures_words(worst, physical) : "no rest";
  };
  section.row("period", words(outlook.period));
  section.row("all records", words(outlook.scale));
}

}  // namespace stillpoint::report
