// SPDX-License-Identifier: MIT
#include <stillpoint/report/spectrum.hpp>
#include "format.hpp"
#include "sections.hpp"

#include <stillpoint/report/digits.hpp>
#include <stillpoint/report/findings.hpp>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <numbers>
#include <optional>
#include <set>
#include <utility>

namespace stillpoint::report {

namespace {

using design::Figures;
using design::SpectrumPoint;

/// At even steps; more do not fit a screen, and a file has them all.
constexpr std::size_t most_even_periods = 7;

/// Those, and the periods of the largest of each figure; all rather than all but a few.
std::set<std::size_t> shown_periods(const std::vector<SpectrumPoint>& points) {
  std::set<std::size_t> shown;
  const std::size_t even = std::min(points.size(), most_even_periods);
  for (std::size_t row = 0; row < even; ++row) {
    shown.insert(even > 1 ? row * (points.size() - 1) / (even - 1) : 0);
  }
  const auto add_largest = [&](auto Figures::*figure) {
    for (const auto of : {&SpectrumPoint::with_notch, &SpectrumPoint::without}) {
      const auto most = std::ranges::max_element(
          points, {}, [&](const SpectrumPoint& point) { return point.*of.*figure; });
      shown.insert(static_cast<std::size_t>(most - points.begin()));
    }
  };
  add_largest(&Figures::acceleration);
  add_largest(&Figures::peak);
  add_largest(&Figures::residual);
  add_largest(&Figures::jump);
  constexpr std::size_t few = 6;
  for (std::size_t i = 0; points.size() <= shown.size() + few && i < points.size(); ++i) {
    shown.insert(i);
  }
  return shown;
}

/// Whether the structure never feels more than what the notch passes on while it is locked, so that
/// what it lowers is beside the point.
bool only_locked(const SpectrumReport& report) {
  return std::ranges::all_of(report.result.combined, [](const SpectrumPoint& point) {
    return point.with_notch.largest_load_while_locked == point.with_notch.acceleration;
  });
}

/// "Largest of 2 records"
std::string whose(const SpectrumReport& report) {
  return design::suite_words(*report.result.request.combine, report.result.records.size());
}

/// The largest of each figure of friction alone, and the period at which it occurs.
std::string friction_words(const SpectrumReport& report) {
  const std::vector<SpectrumPoint>& points = report.result.combined;
  const FigureUnits units = units_of(report.physical);
  const auto largest = [&](auto Figures::*figure, const auto& words) {
    const auto most = std::ranges::max_element(
        points, {}, [&](const SpectrumPoint& point) { return point.without.*figure; });
    const std::optional<double> value = most->without.*figure;
    return format("{} at {}", words(*value), period_words(report.physical, most->p));
  };
  const auto length = [&](double value) { return units.length.words(value); };
  const bool settles = report.result.resting(&SpectrumPoint::without) == points.size();
  return format("{}: {}friction alone transmits at most {}; its largest peak is {}, {}.",
                whose(report), report.result.request.delta > 0 ? "without the notch, " : "",
                largest(&Figures::acceleration, acceleration_shown),
                largest(&Figures::peak, length),
                settles ? "its largest residual " + largest(&Figures::residual, length)
                        : "and at some period the mass never comes to rest");
}

/// In the units of the figures. Without a notch there is nothing to compare with.
Table spectrum_table(const SpectrumReport& report, const std::vector<SpectrumPoint>& points) {
  const FigureUnits units = units_of(report.physical);
  const auto number = [](double value) { return format("{:.5g}", value); };
  const auto residual = [&](const Figures& one) {
    return one.residual ? number(*one.residual * units.length) : "none";
  };
  const auto compared = [&](std::string words) {
    return report.result.request.delta > 0 ? std::move(words) : "";
  };
  const auto jump = [&](double value) { return value > 0 ? number(value * units.velocity) : ""; };
  Table table{{"period, s", "transmitted, g", "transmitted without, g", in("peak", units.length),
               in("peak without", units.length), in("residual", units.length),
               in("residual without", units.length), in("jump", units.velocity)},
              {}};
  for (const std::size_t i : shown_periods(points)) {
    const auto& [with, without, p] = points[i];
    table.rows.push_back({{number(2 * std::numbers::pi / p * units.time), number(with.acceleration),
                           compared(number(without.acceleration)), number(with.peak * units.length),
                           compared(number(without.peak * units.length)), residual(with),
                           compared(residual(without)), jump(with.jump)}});
  }
  return without_empty_columns(std::move(table));
}

void add_points(Section& section, const SpectrumReport& report,
                const std::vector<SpectrumPoint>& points) {
  Table table = spectrum_table(report, points);
  const std::size_t shown = table.rows.size();
  section.parts.emplace_back(std::move(table));
  if (points.size() > shown) {
    section.line(format("{} of {} periods, with those of the largest of each figure; --table FILE "
                        "has all.",
                        shown, points.size()),
                 Tone::faint);
  }
}

void add_damper(Section& answer, const SpectrumReport& report) {
  const design::SpectrumRequest& task = report.result.request;
  answer.row("damper", format("f = {}, delta = {}, the same at every period", digits(task.f),
                              length_shown(report.physical, task.delta)));
  if (task.hold) {
    answer.row("notch", format("lets go at {} above f", acceleration_shown(*task.hold)));
  }
  if (task.notch_width) {
    answer.row("notch", length_shown(report.physical, *task.notch_width) + " wide");
  }
  if (task.delta > 0 && !task.notch_width && !task.hold) {
    const double peak = std::ranges::max(report.result.combined, {}, [](const SpectrumPoint& now) {
                          return now.with_notch.peak;
                        }).with_notch.peak;
    const double stiffest = std::ranges::max(task.p);
    answer.row("in the notch",
               inside_example(report.physical, {stiffest, task.f, task.delta}, peak));
  }
  for (const design::SuiteRecord& record : task.records) {
    answer.row(&record == task.records.data() ? "record" : "",
               format("{}, {} long",
                      record_words(record.name, record.scale, name(record.units), record.assumed_g,
                                   design::peak_load(record)),
                      time_shown(report.physical, *duration(design::scaled(record)))));
  }
}

}  // namespace

std::string verdict(const SpectrumReport& report) {
  const design::Spectrum& result = report.result;
  return result.request.delta == 0 || only_locked(report) ? friction_words(report)
                                                          : design::summary(result);
}

Document document(const SpectrumReport& report) {
  const design::Spectrum& result = report.result;
  Document document = answered("Response spectrum", report, Tone::plain);
  add_damper(document.answer, report);
  add_findings(document, result.findings, report.physical);
  const std::size_t count = result.records.size();
  add_points(
      document.section(whose(report) + (result.request.delta > 0 ? ", with the notch and without it"
                                                                 : ", friction alone")),
      report, result.combined);
  for (std::size_t i = 0; i < count && count > 1; ++i) {
    Section& record = document.detail(record_label(result.request.records[i]));
    record.folded = true;
    add_points(record, report, result.records[i]);
  }
  return document;
}

}  // namespace stillpoint::report
