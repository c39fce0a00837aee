// SPDX-License-Identifier: MIT
#include <stillpoint/report/spectrum.hpp>
#include "sections.hpp"

#include <stillpoint/report/findings.hpp>

#include <cstddef>
#include <numbers>

namespace stillpoint::report {

namespace {

using design::Figures;
using design::SpectrumPoint;

/// "Largest of 2 records"
std::string whose(const SpectrumReport& report) {
  return design::suite_words(*report.result.request.combine, report.result.records.size());
}

/// The largest of two figures of friction alone, and the periods at which they occur.
std::string friction_words(const SpectrumReport& report) {
  const auto largest = [&](double Figures::*figure, Dimension dimension) {
    const auto of = [&](const SpectrumPoint& point) { return point.without.*figure; };
    const SpectrumPoint most = std::ranges::max(report.result.combined, {}, of);
    return format("{} at {}", figure_shown(report.physical, dimension, of(most)),
                  period_words(report.physical, most.p));
  };
  return format("{}: friction alone transmits at most {}; its largest peak is {}.", whose(report),
                largest(&Figures::acceleration, Dimension::gravities),
                largest(&Figures::peak, Dimension::length));
}

/// At even steps; more do not fit a screen, and a file has them all. In the units of the figures.
/// Without a notch there is nothing to compare with.
void add_points(Section& section, const SpectrumReport& report,
                const std::vector<SpectrumPoint>& points) {
  constexpr std::size_t most_periods = 12;
  const FigureUnits units = units_of(report.physical);
  const bool compared = report.result.request.damper.delta > 0;
  const auto cell = [](const std::optional<double>& value, const Unit& unit) {
    return value ? format("{:.5g}", *value * unit) : "none";
  };
  Table table{{"period, s", "transmitted, g", "transmitted alone, g", in("peak", units.length),
               in("peak alone", units.length), in("residual", units.length),
               in("residual alone", units.length), in("jump", units.velocity)},
              {}};
  const std::size_t step = (points.size() + most_periods - 1) / most_periods;
  for (std::size_t i = 0; i < points.size(); i += step) {
    const auto& [with, without, p] = points[i];
    table.rows.push_back(
        {{cell(2 * std::numbers::pi / p, units.time), cell(with.acceleration, {}),
          compared ? cell(without.acceleration, {}) : "", cell(with.peak, units.length),
          compared ? cell(without.peak, units.length) : "", cell(with.residual, units.length),
          compared ? cell(without.residual, units.length) : "",
          with.jump > 0 ? cell(with.jump, units.velocity) : ""}});
  }
  const std::size_t shown = table.rows.size();
  section.parts.emplace_back(without_empty_columns(std::move(table)));
  section.line(
      step > 1 ? format("{} of {} periods; --table FILE has all.", shown, points.size()) : "",
      Tone::faint);
}

}  // namespace

std::string verdict(const SpectrumReport& report) {
  return report.result.request.damper.delta == 0 ? friction_words(report)
                                                 : design::summary(report.result);
}

Document document(const SpectrumReport& report) {
  const design::Spectrum& result = report.result;
  const design::SpectrumRequest& task = result.request;
  const Oscillator& damper = task.damper;
  Document document = answered("Response spectrum", report, Tone::plain);
  document.answer.row("damper", damper_words(report.physical, damper.f, damper.delta,
                                             {task.notch_width, damper.hold}, 6) +
                                    ", the same at every period");
  add_damping(document.answer, damper);
  std::string label = "record";
  for (const design::SuiteRecord& record : task.records) {
    document.answer.row(std::exchange(label, ""),
                        format("{}, {} long",
                               record_words(record.name, record.scale, name(record.units),
                                            record.assumed_g, design::peak_load(record)),
                               time_shown(report.physical, *duration(design::scaled(record)))));
  }
  add_findings(document, result.findings, report.physical);
  const std::size_t count = result.records.size();
  add_points(document.section(whose(report) + (damper.delta > 0
                                                   ? ", with the notch and with friction alone"
                                                   : ", friction alone")),
             report, result.combined);
  for (std::size_t i = 0; i < count && count > 1; ++i) {
    Section& record = document.detail(scaled_name(task.records[i].name, task.records[i].scale));
    add_points(record, report, result.records[i]);
  }
  return document;
}

}  // namespace stillpoint::report
