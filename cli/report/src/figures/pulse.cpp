// SPDX-License-Identifier: MIT
// The plane of f and Delta for a mass that a pulse moves from rest.
#include "figures/region_column.hpp"
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

namespace {

constexpr int curve_steps = 200;
constexpr double headroom = 1.15;

/// The least Delta over f, in strokes that end where the mass does not return.
using LeastDelta = std::function<std::optional<double>(double)>;

FigureCurve needs(const LeastDelta& least_delta, double last, const FigureUnits& units) {
  FigureCurve curve{"least Δ allowed", {{}}, Ink::purple};
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
std::vector<FigurePoint> beside_the_curve(const LeastDelta& least_delta, const Interval& interval,
                                          double top, double end, double unit) {
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

/// The admissible islands, and beside each why its neighbours are not.
void add_pulse_areas(Figure& figure, const DrawnPulseRegion& drawn, const LeastDelta& least_delta,
                     const FigureUnits& units) {
  design::PulseProblem problem = drawn.problem;  // what the motion does
  problem.criterion = design::Criterion::exact;
  const LeastDelta exact = design::least_delta(problem);
  const double right = figure.x.most;
  const double top = figure.y.most;
  const double cap = std::min(top, design::largest_delta_allowed(drawn.limits) * units.length);
  const std::string exceeds = "exceeds " + units.length_words(drawn.problem.beta);
  double from = 0;
  for (const auto& interval : drawn.intervals) {
    figure.areas.push_back(
        {drawn.limits.tolerance > 0 ? "admissible without a tolerance" : "admissible",
         beside_the_curve(least_delta, interval, cap, cap, units.length), Ink::sky});
    figure.areas.push_back({"notch too weak",
                            beside_the_curve(exact, interval, cap, 0, units.length), Ink::grey,
                            AreaLook::hatched});
    if (drawn.problem.criterion == design::Criterion::published) {
      const auto between = [&](double f) {
        const double low = exact(f).value_or(0) * units.length;
        const double high = std::min(least_delta(f).value_or(0) * units.length, cap);
        return low < high ? std::optional(Interval{low, high}) : std::nullopt;
      };
      figure.areas.push_back({std::string(by_criterion_alone), outline_over(interval, 1, between),
                              Ink::amber, AreaLook::hatched});
    }
    constexpr double seen = 1e-3;  // of the axis
    if (interval.low - from > seen * right) {
      figure.areas.push_back({from == 0 ? "too weak: " + exceeds : "does not meet the limits",
                              rectangle(from, interval.low, 0, top), Ink::grey, AreaLook::hatched});
    }
    if (cap < top) {
      figure.areas.push_back({"above the largest Δ",
                              rectangle(interval.low, interval.high, cap, top), Ink::amber,
                              AreaLook::hatched});
    }
    from = interval.high;
  }
  const double returns = std::clamp(drawn.region.f3, from, right);
  if (returns > from) {
    const bool nowhere_in_reach = from == 0 && drawn.region.beta_min > drawn.problem.beta;
    figure.areas.push_back({nowhere_in_reach ? exceeds : "does not meet the limits",
                            rectangle(from, returns, 0, top), Ink::grey, AreaLook::hatched});
  }
  if (right > returns) {
    const bool up_to_the_load = drawn.region.beta_min == 0;
    figure.areas.push_back(
        {up_to_the_load ? "too strong: never starts" : "too strong: does not return",
         rectangle(returns, right, 0, top), Ink::grey, AreaLook::hatched});
  }
}

/// The areas of the dampers that keep the tolerance asked for, up to `top`.
std::vector<std::vector<FigurePoint>> tolerant_areas(const DrawnPulseRegion& drawn, double top,
                                                     double unit) {
  std::vector<std::vector<FigurePoint>> areas;
  if (drawn.limits.tolerance > 0 && drawn.region.feasible) {
    const auto feasible = design::feasible_delta(drawn.problem, drawn.limits);
    for (const Interval& interval : drawn.intervals) {
      areas.push_back(outline_over(interval, unit, [&](double f) {
        auto delta = feasible(f);
        if (delta) {
          delta->high = std::min(delta->high, top / unit);
        }
        return delta && delta->low <= delta->high ? delta : std::nullopt;
      }));
    }
  }
  return areas;
}

/// The far corner of what is shown of f and Delta.
FigurePoint far_corner(const DrawnPulseRegion& drawn, double unit) {
  FigurePoint far{
      std::max(drawn.region.f3, drawn.intervals.empty() ? 0 : drawn.intervals.back().high), 0};
  if (drawn.damper) {
    for (const FigurePoint& corner : tolerance_box(*drawn.damper, drawn.limits.shape, unit)) {
      far = {std::max(far.x, corner.x), std::max(far.y, corner.y)};
    }
  }
  return far;
}

/// Of the curve and of a limit not far above it.
double topmost(const FigureCurve& curve, double least, double limit) {
  for (const auto& stroke : curve.strokes) {
    for (const FigurePoint& at : stroke) {
      least = std::max(least, at.y);
    }
  }
  constexpr double far = 1.5;  // from there on it would flatten the curve
  return limit < far * least ? std::max(least, limit) : least;
}

}  // namespace

Figure pulse_region_figure(const DrawnPulseRegion& drawn, const FigureUnits& units) {
  Figure figure;
  figure.id = "region";
  figure.title = drawn.region.feasible ? "Admissible region" : drawn.mend;
  const LeastDelta least_delta = design::least_delta(drawn.problem);
  const FigurePoint far = far_corner(drawn, units.length);
  const double right = headroom * far.x;
  FigureCurve curve = needs(least_delta, right, units);
  figure.x = {"constant friction f", 0, right};
  const double limit = design::largest_delta_allowed(drawn.limits) * units.length;
  figure.y = {units.delta_label, 0, headroom * topmost(curve, far.y, limit)};
  figure.description = format(
      "The plane of f and Δ under the pulse. No f above {:.4g} lets the mass return; "
      "where it does, every Δ above the curve stops it. ",
      drawn.region.f3);
  const bool bounded = std::isfinite(design::largest_delta_allowed(drawn.limits));
  figure.caption =
      drawn.intervals.empty()
          ? "With every f the mass misses x = 0 or violates a limit."
          : format(
                "{}{}.", region_clause(drawn.damper, drawn.region, drawn.limits, units),
                bounded ? "" : "; nothing bounds Δ from above, because the mass starts from rest");
  add_pulse_areas(figure, drawn, least_delta, units);
  figure.curves.push_back(std::move(curve));
  add_tolerant(figure, drawn.limits, tolerant_areas(drawn, figure.y.most, units.length));
  if (drawn.damper) {
    add_damper(figure, *drawn.damper, drawn.limits.shape, units);
  }
  caption_inset(figure, units);
  return figure;
}

}  // namespace stillpoint::report
