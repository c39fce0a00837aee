// SPDX-License-Identifier: MIT
// The plane of f and Delta for a mass that a pulse moves from rest.
#include "figures/report_figures.hpp"
#include "format.hpp"

#include <algorithm>
#include <cmath>
#include <functional>
#include <optional>
#include <utility>
#include <vector>

namespace stillpoint::report {

using figures::AreaLook;
using figures::Figure;
using figures::FigureCurve;
using figures::FigurePoint;
using figures::Ink;
using figures::Shape;

namespace {

constexpr int curve_steps = 200;
constexpr double headroom = 1.15;

/// The least Delta over f, in strokes that end where the mass does not return.
using LeastDelta = std::function<std::optional<double>(double)>;

FigureCurve needs(const LeastDelta& least_delta, double last, const FigureUnits& units) {
  FigureCurve curve{"least Δ that stops it", {{}}, Ink::purple};
  for (int i = 1; i <= curve_steps; ++i) {
    const double f = last * i / curve_steps;
    if (const auto least = least_delta(f)) {
      curve.strokes.back().push_back({f, *least * units.length});
    } else if (!curve.strokes.back().empty()) {
      curve.strokes.emplace_back();
    }
  }
  if (curve.strokes.back().empty()) {
    curve.strokes.pop_back();
  }
  return curve;
}

/// From the curve, where it is below `top`, to `end`.
std::vector<FigurePoint> beside_the_curve(const LeastDelta& least_delta,
                                          const design::FrictionInterval& interval, double top,
                                          double end, double unit) {
  std::vector<FigurePoint> outline;
  for (int i = 0; i <= curve_steps; ++i) {
    const double f = interval.low + (interval.high - interval.low) * i / curve_steps;
    const auto least = least_delta(f);
    outline.push_back({f, std::min(least ? *least * unit : 0, top)});
  }
  outline.push_back({interval.high, end});
  outline.push_back({interval.low, end});
  return outline;
}

std::vector<FigurePoint> rectangle(double left, double right, double low, double high) {
  return {{left, low}, {right, low}, {right, high}, {left, high}};
}

}  // namespace

Figure pulse_region_figure(const DrawnPulseRegion& drawn, const FigureUnits& units) {
  const auto& [problem, limits, region, intervals, damper, mend] = drawn;
  const double unit = units.length;
  Figure figure;
  figure.id = "region";
  figure.title = region.feasible ? "Admissible region" : mend;
  const auto box = damper ? tolerance_box(*damper, limits.shape, unit) : std::vector<FigurePoint>{};
  double right = std::max(region.f3, intervals.empty() ? 0 : intervals.back().high);
  for (const FigurePoint& corner : box) {
    right = std::max(right, corner.x);
  }
  right *= headroom;
  const LeastDelta least_delta = design::least_delta(problem);
  FigureCurve curve = needs(least_delta, right, units);
  double top = 0;
  for (const auto& stroke : curve.strokes) {
    for (const FigurePoint& at : stroke) {
      top = std::max(top, at.y);
    }
  }
  for (const FigurePoint& corner : box) {
    top = std::max(top, corner.y);
  }
  top *= headroom;
  figure.x = {"constant friction f", 0, right};
  figure.y = {units.delta_label, 0, top};
  figure.description = format(
      "The plane of f and Δ under the pulse. The mass returns up to f = {:.4g}; every Δ "
      "above the curve stops it there. ",
      region.f3);
  figure.caption = intervals.empty() ? "No f returns and meets the limits."
                   : limits.delta_max
                       ? "A damper in the clear area is admissible."
                       : "A damper in the clear area is admissible: nothing bounds Δ from "
                         "above, because the mass starts from rest.";
  const double cap = std::min(top, limits.delta_max.value_or(HUGE_VAL) * unit);
  double from = 0;
  for (const auto& interval : intervals) {
    figure.areas.push_back(
        {"admissible", beside_the_curve(least_delta, interval, cap, cap, unit), Ink::sky});
    figure.areas.push_back({"notch too weak", beside_the_curve(least_delta, interval, cap, 0, unit),
                            Ink::grey, AreaLook::hatched});
    if (interval.low > from) {
      figure.areas.push_back({from == 0 ? "too weak: exceeds " + units.length_words(problem.beta)
                                        : "does not meet the limits",
                              rectangle(from, interval.low, 0, top), Ink::grey, AreaLook::hatched});
    }
    from = interval.high;
  }
  figure.areas.push_back({intervals.empty() ? "not admissible" : "too strong",
                          rectangle(from, right, 0, top), Ink::grey, AreaLook::hatched});
  if (cap < top && from > 0) {
    figure.areas.push_back(
        {"above the largest Δ", rectangle(0, from, cap, top), Ink::amber, AreaLook::hatched});
  }
  figure.curves.push_back(std::move(curve));
  if (damper) {
    const std::string words = tolerance_words(limits.shape, damper->tolerance);
    if (damper->tolerance > 0) {
      figure.areas.push_back({words, box, Ink::blue, AreaLook::box});
    }
    figure.marks.push_back(
        {damper->name, {{damper->f, damper->delta * unit}}, Shape::diamond, Ink::blue});
    figure.description += format("{} at f = {:.4g}, Δ = {}, {}.", damper->name, damper->f,
                                 units.length_words(damper->delta), words);
  }
  return figure;
}

}  // namespace stillpoint::report
