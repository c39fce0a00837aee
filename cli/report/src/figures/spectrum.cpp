// SPDX-License-Identifier: MIT
#include "figures/lines.hpp"
#include "figures/report_figures.hpp"
#include "format.hpp"
#include "sections.hpp"

#include <stillpoint/report/record_design.hpp>
#include <stillpoint/report/spectrum.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <iterator>
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

  [[nodiscard]] std::vector<std::vector<FigurePoint>> strokes(
      const std::vector<SpectrumPoint>& points, SpectrumFigures SpectrumPoint::*which) const {
    auto point = points.begin();
    return line_over(periods, [&](double) {
      const auto value = drawn((*point++).*which);
      return value ? std::optional(*value * unit) : std::nullopt;
    });
  }
};

/// Of the points from one x to another; (first, 0) if all are at 0.
FigurePoint highest(const FigureCurve& curve, double first = 0, double last = HUGE_VAL) {
  FigurePoint most{first, 0};
  for (const auto& stroke : curve.strokes) {
    for (const FigurePoint& point : stroke) {
      if (first <= point.x && point.x <= last && point.y > most.y) {
        most = point;
      }
    }
  }
  return most;
}

/// So few periods that a line between them would look like more.
void add_points(Figure& figure, std::size_t periods) {
  constexpr std::size_t few = 20;
  if (periods > few) {
    return;
  }
  for (const FigureCurve& curve : figure.curves) {
    if (curve.hover) {
      figure.marks.push_back({curve.name, {}, figures::Shape::disc, curve.ink});
      for (const auto& stroke : curve.strokes) {
        std::ranges::copy(stroke, std::back_inserter(figure.marks.back().points));
      }
    }
  }
}

/// The line of each record, faint behind those of all together.
void add_curves(Figure& figure, const design::Spectrum& spectrum, const SpectrumAxes& axes) {
  const bool several = spectrum.records.size() > 1;
  const std::string which = !several                                            ? ""
                            : *spectrum.request.combine == design::Combine::max ? "largest, "
                                                                                : "mean, ";
  if (several) {
    FigureCurve each = figures::line("each record", {}, Ink::grey);
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
  figure.curves.push_back({which + "without the notch",
                           axes.strokes(spectrum.combined, &SpectrumPoint::without), Ink::orange,
                           figures::Dash::dashed});
  figure.curves.push_back({which + "with the notch",
                           axes.strokes(spectrum.combined, &SpectrumPoint::with_notch), Ink::blue});
}

struct Kind {
  std::string_view quantity;
  std::string_view axis;
  records::Dimension dimension;
  Drawn drawn;
};
constexpr std::array kinds{
    Kind{"transmitted acceleration", "acceleration", records::Dimension::gravities,
         [](const SpectrumFigures& one) { return std::optional(one.acceleration); }},
    Kind{"peak displacement", "peak", records::Dimension::length,
         [](const SpectrumFigures& one) { return std::optional(one.peak); }},
    Kind{"residual displacement", "residual", records::Dimension::length,
         [](const SpectrumFigures& one) { return one.residual; }}};

/// What it comes to: its largest value, or the largest about the period of a design.
std::vector<std::string> clauses(const std::string& name, const std::string& unit,
                                 const Figure& figure, const design::Spectrum& spectrum,
                                 const FigureUnits& units, const std::optional<double>& chosen) {
  const auto value = [&](double y) { return format("{:.4g}{}", y, with_blank(unit)); };
  const FigureCurve& shown = figure.curves.back();
  if (chosen) {
    constexpr double about = 0.05;
    const double most = highest(shown, (1 - about) * *chosen, (1 + about) * *chosen).y;
    return {format("Within {} % of the period of the design, the {} is {}", 100 * about, name,
                   most == 0 ? "zero" : "at most " + value(most))};
  }
  const auto words = [&](const FigureCurve& curve) {
    if (curve.strokes.empty()) {
      return std::string("undefined, because the mass never comes to rest");
    }
    const FigurePoint most = highest(curve);
    return most.y > 0 ? format("at most {}, at a period of {:.4g}{}", value(most.y), most.x,
                               units.time.name.empty() ? "" : " s")
                      : "zero";
  };
  std::vector<std::string> said{format("The {} is {}", name, words(shown))};
  if (spectrum.request.delta > 0) {
    said.push_back("without the notch " + words(*std::prev(figure.curves.end(), 2)));
  }
  return said;
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
  std::vector<Figure> all;
  for (const Kind& kind : kinds) {
    const Unit unit = units.of(kind.dimension);
    const bool felt = kind.dimension == records::Dimension::gravities;
    const std::string name =
        format("{}{}", kind.quantity,
               felt ? jumps_words(spectrum.request.delta, spectrum.request.notch_width) : "");
    Figure figure;
    figure.id = format("spectrum-{}", kind.axis);
    figure.title = format("Spectrum of the {}", kind.quantity);
    figure.height = 170;
    figure.x = figures::axis_around(units.time.name.empty() ? "period 2π/p" : "period, s", shortest,
                                    longest);
    figure.x.least = std::max(figure.x.least, 0.0);
    add_curves(figure, spectrum, {kind.drawn, unit.factor, periods});
    figure.clauses = clauses(name, unit.name, figure, spectrum, units,
                             chosen ? std::optional(period(*chosen)) : std::nullopt);
    add_points(figure, periods.size());
    double most = 0;
    for (const FigureCurve& curve : figure.curves) {
      most = std::max(most, highest(curve).y);
    }
    constexpr double above_most = 1.08;
    constexpr double below_zero = -0.02;  // so that a line at 0 is seen whole
    most = most > 0 ? above_most * most : 1;
    figure.y = {in(kind.axis, unit), below_zero * most, most};
    if (chosen) {
      const double at = period(*chosen);
      figure.curves.push_back(figures::line("period of the design",
                                            {{{at, figure.y.least}, {at, figure.y.most}}},
                                            Ink::green, figures::Dash::dotted));
    }
    figure.description =
        format("The {} against the period from {:.4g} to {:.4g}.", name, shortest, longest);
    all.push_back(std::move(figure));
  }
  const auto moves_without = [](const SpectrumPoint& point) { return !point.without.residual; };
  const auto moves = [&](const SpectrumPoint& point) {
    return !point.with_notch.residual || moves_without(point);
  };
  if (std::ranges::all_of(spectrum.combined, moves_without)) {
    if (chosen) {  // else it is said
      all.back().clauses.emplace_back("without the notch the mass never comes to rest");
    }
  } else if (std::ranges::any_of(spectrum.combined, moves)) {
    all.back().clauses.emplace_back("a line has a gap where the mass does not come to rest");
  }
  return all;
}

std::vector<Figure> drawings(const SpectrumReport& report) {
  return report.result.combined.size() > 1  // the table says more than two dots
             ? spectrum_figures(report.result, units_of(report.physical))
             : std::vector<Figure>();
}

}  // namespace stillpoint::report
