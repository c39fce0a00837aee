// SPDX-License-Identifier: MIT
#include "figures/spectrum_parts.hpp"
#include "format.hpp"

#include <stillpoint/report/record_design.hpp>
#include <stillpoint/report/spectrum.hpp>

#include <algorithm>
#include <cstddef>
#include <numbers>
#include <string>
#include <utility>

namespace stillpoint::report {

using figures::Figure;
using figures::FigureCurve;
using figures::FigurePoint;
using figures::Ink;

namespace {

using design::SpectrumFigures;
using design::SpectrumPoint;

/// The value drawn for a motion; empty if it does not exist.
using Drawn = std::optional<double> (*)(const SpectrumFigures&);

struct SpectrumAxes {
  Drawn drawn;
  double unit;
  std::vector<double> periods;  ///< in the unit of the axis

  /// A stroke ends where a value does not exist.
  [[nodiscard]] std::vector<std::vector<FigurePoint>> strokes(
      const std::vector<SpectrumPoint>& points, SpectrumFigures SpectrumPoint::*which) const {
    std::vector<std::vector<FigurePoint>> strokes{{}};
    for (std::size_t i = 0; i < points.size(); ++i) {
      if (const auto value = drawn(points[i].*which)) {
        strokes.back().push_back({periods[i], *value * unit});
      } else if (!strokes.back().empty()) {
        strokes.emplace_back();
      }
    }
    std::erase_if(strokes, [](const auto& stroke) { return stroke.empty(); });
    return strokes;
  }
};

double highest(const std::vector<std::vector<FigurePoint>>& strokes) {
  double most = 0;
  for (const auto& stroke : strokes) {
    for (const FigurePoint& point : stroke) {
      most = std::max(most, point.y);
    }
  }
  return most;
}

/// The line of each record, faint behind those of all together.
void add_curves(Figure& figure, const design::Spectrum& spectrum, const SpectrumAxes& axes) {
  const bool several = spectrum.records.size() > 1;
  const std::string which = !several                                            ? ""
                            : *spectrum.request.combine == design::Combine::max ? "largest, "
                                                                                : "mean, ";
  if (several) {
    FigureCurve each{"each record", {}, Ink::grey};
    each.hover = false;
    for (const auto& record : spectrum.records) {
      std::ranges::move(axes.strokes(record, &SpectrumPoint::with_notch),
                        std::back_inserter(each.strokes));
    }
    figure.curves.push_back(std::move(each));
  }
  if (spectrum.request.delta == 0) {
    figure.curves.push_back(
        {which + "friction alone", axes.strokes(spectrum.combined, &SpectrumPoint::without)});
    return;
  }
  figure.curves.push_back({which + "without point friction",
                           axes.strokes(spectrum.combined, &SpectrumPoint::without), Ink::orange,
                           figures::Dash::dashed});
  figure.curves.push_back({which + "with the notch",
                           axes.strokes(spectrum.combined, &SpectrumPoint::with_notch), Ink::blue});
}

}  // namespace

std::vector<Figure> spectrum_figures(const design::Spectrum& spectrum, const FigureUnits& units,
                                     const std::optional<double>& chosen) {
  const auto period = [&](double p) { return 2 * std::numbers::pi / p * units.time; };
  std::vector<double> periods;
  periods.reserve(spectrum.request.p.size());
  for (const double p : spectrum.request.p) {
    periods.push_back(period(p));
  }
  const auto [shortest, longest] = std::ranges::minmax(periods);
  struct Kind {
    std::string_view id;
    std::string name;
    std::string label;
    double unit;
    Drawn drawn;
  };
  const std::vector<Kind> kinds{
      {spectrum_figure_names[0], "transmitted acceleration", "acceleration, g", 1,
       [](const SpectrumFigures& one) { return std::optional(one.acceleration); }},
      {spectrum_figure_names[1], "peak displacement", in("peak", units.length_unit), units.length,
       [](const SpectrumFigures& one) { return std::optional(one.peak); }},
      {spectrum_figure_names[2], "residual displacement", in("residual", units.length_unit),
       units.length, [](const SpectrumFigures& one) { return one.residual; }}};
  std::vector<Figure> all;
  for (const Kind& kind : kinds) {
    Figure figure;
    figure.id = kind.id;
    figure.title = format("Spectrum of the {}", kind.name);
    figure.height = 170;
    figure.x = figures::axis_around(units.time_unit.empty() ? "period 2π/p" : "period, s", shortest,
                                    longest);
    figure.x.least = std::max(figure.x.least, 0.0);
    add_curves(figure, spectrum, {kind.drawn, kind.unit, periods});
    double most = 0;
    for (const FigureCurve& curve : figure.curves) {
      most = std::max(most, highest(curve.strokes));
    }
    constexpr double above_most = 1.08;
    constexpr double below_zero = -0.02;  // so that a line at 0 is seen whole
    most = most > 0 ? above_most * most : 1;
    figure.y = {kind.label, below_zero * most, most};
    if (chosen) {
      const double at = period(*chosen);
      FigureCurve line{
          "period of the design", {{{at, figure.y.least}, {at, figure.y.most}}}, Ink::green};
      line.dash = figures::Dash::dotted;
      line.hover = false;
      figure.curves.push_back(std::move(line));
    }
    figure.description = format(
        "The {} over the period from {:.4g} to {:.4g}, with the notch and without, f and Δ fixed.",
        kind.name, shortest, longest);
    figure.caption = format("The {} over the period, with the same {} at every period.", kind.name,
                            spectrum.request.delta > 0 ? "f and Δ" : "f");
    all.push_back(std::move(figure));
  }
  const auto never_rests = [](const SpectrumPoint& point) {
    return !point.with_notch.residual || !point.without.residual;
  };
  if (std::ranges::any_of(spectrum.combined, never_rests)) {
    all.back().caption.back() = ';';
    all.back().caption += " a line has a gap where the mass does not come to rest.";
  }
  return all;
}

figures::HtmlPage page(const SpectrumReport& report) {
  figures::HtmlPage page = page_of(document(report));
  page.figures = spectrum_figures(report.result, FigureUnits(report.physical));
  return page;
}

}  // namespace stillpoint::report
