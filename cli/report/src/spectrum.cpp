// SPDX-License-Identifier: MIT
#include <stillpoint/report/spectrum.hpp>
#include "format.hpp"
#include "units.hpp"

#include <stillpoint/report/digits.hpp>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <numbers>

namespace stillpoint::report {

namespace {

using design::SpectrumFigures;
using design::SpectrumPoint;

/// More do not fit a screen; a file has all.
constexpr std::size_t most_shown_periods = 20;

/// Where the notch holds the mass while the load goes on; empty if nowhere.
std::string lock_words(const SpectrumReport& report) {
  const std::vector<SpectrumPoint>& points = report.result.combined;
  std::size_t count = 0;
  double most = 0;
  for (const SpectrumPoint& point : points) {
    if (point.with_notch.locked_from) {
      ++count;
      most = std::max(most, *point.with_notch.largest_load_while_locked);
    }
  }
  return count == 0 ? ""
                    : format(
                          "at {} of {} periods the notch holds it to the end of a record, "
                          "against up to {}",
                          count, points.size(), acceleration_shown(most));
}

/// In the units of the figures.
Table spectrum_table(const SpectrumReport& report, const std::vector<SpectrumPoint>& points) {
  const FigureUnits units(report.physical);
  const auto number = [](double value) { return format("{:.5g}", value); };
  const auto residual = [&](const SpectrumFigures& one) {
    return one.residual ? number(*one.residual * units.length) : "none";
  };
  Table table{{"period, s", "acceleration, g", "without", "peak, " + units.length_unit, "without",
               "residual, " + units.length_unit, "without"},
              {}};
  const std::size_t shown = std::min(points.size(), most_shown_periods);
  for (std::size_t row = 0; row < shown; ++row) {
    const std::size_t i = shown > 1 ? row * (points.size() - 1) / (shown - 1) : 0;
    const auto& [with_notch, without] = points[i];
    table.rows.push_back(
        {{number(2 * std::numbers::pi / report.result.request.p[i] * units.time),
          number(with_notch.acceleration), number(without.acceleration),
          number(with_notch.peak * units.length), number(without.peak * units.length),
          residual(with_notch), residual(without)}});
  }
  return table;
}

void add_points(Section& section, const SpectrumReport& report,
                const std::vector<SpectrumPoint>& points) {
  section.parts.emplace_back(spectrum_table(report, points));
  if (points.size() > most_shown_periods) {
    section.line(
        format("{} of {} periods; --table FILE has all.", most_shown_periods, points.size()),
        Tone::faint);
  }
}

void add_damper(Document& document, const SpectrumReport& report) {
  const design::SpectrumRequest& task = report.result.request;
  Section& section = document.detail("Damper");
  section.row("f", digits(task.f));
  section.row("delta", length_shown(report.physical, task.delta));
  if (task.hold) {
    section.row("notch", format("holds {} besides f", acceleration_shown(*task.hold)));
  }
  if (task.notch_width) {
    section.row("notch", format("{} wide", length_shown(report.physical, *task.notch_width)));
  }
}

}  // namespace

std::string lock_sentence(const SpectrumReport& report) {
  const std::string words = lock_words(report);
  return words.empty() ? "" : "locked: " + words;
}

Document document(const SpectrumReport& report) {
  const design::Spectrum& result = report.result;
  Document document;
  document.title = "Response spectrum";
  document.verdict = summary(result);
  if (const std::string locked = lock_words(report); !locked.empty()) {
    document.answer.row("locked", locked);
  }
  const std::size_t count = result.records.size();
  add_points(document.section(count == 1 ? "With the notch and without it"
                              : *result.request.combine == design::Combine::max
                                  ? format("Largest of {} records", count)
                                  : format("Mean of {} records", count)),
             report, result.combined);
  for (std::size_t i = 0; i < count && count > 1; ++i) {
    const design::SuiteRecord& record = result.request.records[i];
    add_points(document.detail((record.scale == 1 ? "" : format("{:.4g} x ", record.scale)) +
                               spelled_out(record.name.substr(record.name.rfind('/') + 1))),
               report, result.records[i]);
  }
  add_damper(document, report);
  return document;
}

}  // namespace stillpoint::report
