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

/// The largest of two figures of friction alone, and the periods at which they occur.
std::string friction_words(const SpectrumReport& report) {
  const auto largest = [&](double Figures::*figure, Dimension dimension) {
    const auto of = [&](const SpectrumPoint& point) { return point.without.*figure; };
    const SpectrumPoint most = std::ranges::max(report.result.combined, {}, of);
    return format("{} at {}", figure_shown(report.physical, dimension, of(most)),
                  period_words(report.physical, most.p));
  };
  return format("{}: friction alone transmits at most {}; its largest peak is {}.",
                design::suite_words(report.result.request.load),
                largest(&Figures::acceleration, Dimension::gravities),
                largest(&Figures::peak, Dimension::length));
}

/// "0.4 m/s", "half-sine, peak 5 g, 0.011 s long"; of a record its units as well.
std::string load_words(const design::LoadCase& load, const design::CaseMotion& motion,
                       std::size_t place, const Physical& physical) {
  if (load.v0) {
    return figure_shown(physical, Dimension::velocity, *load.v0);
  }
  const double peak = design::peak_load(motion.load);
  const std::string loaded =
      load.pulse ? format("{}, peak {}", motion.name, acceleration_shown(peak))
                 : record_words(motion.name, motion.scale, name(load.records[place].units),
                                load.records[place].assumed_g, peak);
  return format("{}, {} long", loaded, time_shown(physical, *duration(motion.load)));
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
  const std::vector<design::CaseMotion> motions = design::motions_of(task.load);
  std::string label = task.load.v0 ? "hit" : task.load.pulse ? "pulse" : "record";
  for (std::size_t i = 0; i < motions.size(); ++i) {
    document.answer.row(std::exchange(label, ""),
                        load_words(task.load, motions[i], i, report.physical));
  }
  add_findings(document, result.findings, report.physical);
  const std::string_view which =
      damper.delta > 0 ? ", with the notch and with friction alone" : ", friction alone";
  add_points(document.section(design::suite_words(task.load) + std::string(which)), report,
             result.combined);
  for (std::size_t i = 0; i < motions.size() && motions.size() > 1; ++i) {
    add_points(document.detail(scaled_name(motions[i].name, motions[i].scale)), report,
               result.motions[i]);
  }
  return document;
}

}  // namespace stillpoint::report
