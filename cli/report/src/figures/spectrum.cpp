// SPDX-License-Identifier: MIT
#include "figures/report_figures.hpp"
#include "sections.hpp"

#include <stillpoint/report/spectrum.hpp>

#include <array>
#include <iterator>
#include <numbers>

namespace stillpoint::report {

namespace {

using design::Figures;
using design::SpectrumPoint;

/// A figure of a motion over the period.
struct Kind {
  std::string_view quantity;
  std::string_view axis;
  Dimension dimension;
  std::optional<double> (*drawn)(const Figures&);  ///< empty if it does not exist
};
constexpr std::array kinds{Kind{"transmitted acceleration", "acceleration", Dimension::gravities,
                                [](const Figures& one) { return std::optional(one.acceleration); }},
                           Kind{"peak displacement", "peak", Dimension::length,
                                [](const Figures& one) { return std::optional(one.peak); }},
                           Kind{"residual displacement", "residual", Dimension::length,
                                [](const Figures& one) { return one.residual; }}};

/// A spectrum in the units of its axes.
struct DrawnSpectrum {
  const design::Spectrum& spectrum;
  const FigureUnits& units;
  std::optional<double> chosen;  ///< the period of a design
  std::vector<double> periods{};

  [[nodiscard]] double period(double p) const { return 2 * std::numbers::pi / p * units.time; }
};

/// Of the points from one x to another; (first, 0) if all are at 0.
FigurePoint highest(const FigureCurve& curve, double first = 0, double last = HUGE_VAL) {
  FigurePoint most{first, 0};
  for (const FigurePoint& point : joined(curve.strokes)) {
    if (first <= point.x && point.x <= last && point.y > most.y) {
      most = point;
    }
  }
  return most;
}

/// The line of each record, faint behind those of all together; so few periods that a line between
/// them would look like more as points too.
void add_curves(Figure& figure, const DrawnSpectrum& drawn, const Kind& kind) {
  const auto& [request, motions, combined, findings] = drawn.spectrum;
  const double unit = drawn.units.of(kind.dimension).factor;
  const auto strokes = [&](const std::vector<SpectrumPoint>& points, auto which) {
    auto point = points.begin();
    return line_over(drawn.periods, unit, [&](double) { return kind.drawn((*point++).*which); });
  };
  const bool several = motions.size() > 1;
  const std::string which = !several                                       ? ""
                            : request.load.combine == design::Combine::max ? "largest, "
                                                                           : "mean, ";
  if (several) {
    Strokes each;
    for (const auto& motion : motions) {
      std::ranges::move(strokes(motion, &SpectrumPoint::with_notch), std::back_inserter(each));
    }
    figure.add_line("each record", std::move(each), Ink::grey);
  }
  const Strokes without = strokes(combined, &SpectrumPoint::without);
  if (request.damper.delta == 0) {
    figure.curves.push_back({which + "friction alone", without});
  } else {
    figure.curves.push_back({which + "without the notch", without, Ink::orange, Dash::dashed});
    figure.curves.push_back(
        {which + "with the notch", strokes(combined, &SpectrumPoint::with_notch)});
  }
  constexpr std::size_t few = 20;
  for (const FigureCurve& curve : figure.curves) {
    if (curve.hover && drawn.periods.size() <= few) {
      figure.marks.push_back({curve.name, joined(curve.strokes), Shape::disc, curve.ink});
    }
  }
}

/// What it comes to: its largest value, or the largest about the period of a design.
std::vector<std::string> clauses(const std::string& name, const std::string& unit,
                                 const Figure& figure, const DrawnSpectrum& drawn) {
  const auto value = [&](double y) { return format("{:.4g}{}", y, with_blank(unit)); };
  const FigureCurve& shown = figure.curves.back();
  if (drawn.chosen) {
    constexpr double about = 0.05;
    const double most = highest(shown, (1 - about) * *drawn.chosen, (1 + about) * *drawn.chosen).y;
    return {format("Within {} % of the period of the design, the {} is {}", 100 * about, name,
                   most == 0 ? "zero" : "at most " + value(most))};
  }
  const auto words = [&](const FigureCurve& curve) {
    if (curve.strokes.empty()) {
      return std::string("undefined, because the mass never comes to rest");
    }
    const FigurePoint most = highest(curve);
    return most.y > 0 ? format("at most {}, at a period of {:.4g}{}", value(most.y), most.x,
                               with_blank(drawn.units.time.name))
                      : "zero";
  };
  std::vector<std::string> said{format("The {} is {}", name, words(shown))};
  if (drawn.spectrum.request.damper.delta > 0) {
    said.push_back("without the notch " + words(*std::prev(figure.curves.end(), 2)));
  }
  return said;
}

Figure figure_of(const DrawnSpectrum& drawn, const Kind& kind) {
  const design::SpectrumRequest& request = drawn.spectrum.request;
  const Unit unit = drawn.units.of(kind.dimension);
  const bool felt = kind.dimension == Dimension::gravities;
  const std::string name = format(
      "{}{}", kind.quantity, felt ? jumps_words(request.damper.delta, request.notch_width) : "");
  const auto [shortest, longest] = std::ranges::minmax(drawn.periods);
  Figure figure{format("spectrum-{}", kind.axis), format("Spectrum of the {}", kind.quantity)};
  figure.height = 170;
  figure.x =
      axis_around(drawn.units.time.name.empty() ? "period 2π/p" : "period, s", shortest, longest);
  figure.x.least = std::max(figure.x.least, 0.0);
  add_curves(figure, drawn, kind);
  figure.clauses = clauses(name, unit.name, figure, drawn);
  double most = 0;
  for (const FigureCurve& curve : figure.curves) {
    most = std::max(most, highest(curve).y);
  }
  constexpr double above_most = 1.08;
  constexpr double below_zero = -0.02;  // so that a line at 0 is seen whole
  most = most > 0 ? above_most * most : 1;
  figure.y = {in(kind.axis, unit), below_zero * most, most};
  if (drawn.chosen) {
    figure.add_line("period of the design", {figure.upright(*drawn.chosen)}, Ink::green,
                    Dash::dotted);
  }
  figure.description =
      format("The {} against the period from {:.4g} to {:.4g}.", name, shortest, longest);
  return figure;
}

}  // namespace

std::vector<Figure> spectrum_figures(const design::Spectrum& spectrum, const FigureUnits& units,
                                     const std::optional<double>& chosen) {
  DrawnSpectrum drawn{spectrum, units, {}};
  std::ranges::transform(spectrum.request.p, std::back_inserter(drawn.periods),
                         [&](double p) { return drawn.period(p); });
  if (chosen) {
    drawn.chosen = drawn.period(*chosen);
  }
  std::vector<Figure> all;
  std::ranges::transform(kinds, std::back_inserter(all),
                         [&](const Kind& kind) { return figure_of(drawn, kind); });
  if (spectrum.resting(&SpectrumPoint::without) == 0) {
    if (chosen) {  // else it is said
      all.back().clauses.emplace_back("without the notch the mass never comes to rest");
    }
  } else if (spectrum.resting(&SpectrumPoint::without) < spectrum.combined.size() ||
             spectrum.resting(&SpectrumPoint::with_notch) < spectrum.combined.size()) {
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
