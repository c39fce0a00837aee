// SPDX-License-Identifier: MIT
#include "figures_region.hpp"

#include <fmt/format.h>

#include <algorithm>

namespace stillpoint::cli {

namespace {

using design::Limits;
using design::Problem;
using design::Region;
using fmt::format;

constexpr int steps = 200;  // of a curve over f

/// What the five constraints and the limits leave, tolerance aside. Empty where that is nothing.
std::vector<FigurePoint> admissible_outline(const Problem& problem, const Limits& limits,
                                            const Region& region, double unit) {
  const double first = std::max(region.f2, 0.0);
  const double last = std::min(region.f3, limits.f_max.value_or(region.f3));
  const double top = std::min(region.delta2, limits.delta_max.value_or(region.delta2));
  std::vector<FigurePoint> lower;
  for (int i = 0; first <= last && i <= steps; ++i) {
    const double f = first + (last - first) * i / steps;
    const double bound = std::max(0.0, design::delta1(problem, f));
    if (bound <= top) {
      lower.push_back({f, bound * unit});
    }
  }
  if (lower.size() < 2) {
    return {};
  }
  lower.push_back({lower.back().x, top * unit});
  lower.push_back({lower.front().x, top * unit});
  return lower;
}

std::vector<FigurePoint> box(const DrawnDamper& damper, double unit) {
  const double r = damper.tolerance;
  const double delta = damper.delta * unit;
  return {{damper.f * (1 - r), delta * (1 - r)},
          {damper.f * (1 + r), delta * (1 - r)},
          {damper.f * (1 + r), delta * (1 + r)},
          {damper.f * (1 - r), delta * (1 + r)}};
}

/// A vertical edge named at its upper end, where it lies within the axes.
void add_vertical(Figure& figure, double f, const std::string& name) {
  if (f > figure.x.least && f < figure.x.most) {
    figure.curves.push_back(
        {"", {{{f, figure.y.least}, {f, figure.y.most}}}, Ink::grey, Dash::solid, false});
    figure.notes.push_back({name, {f, figure.y.value(0.985)}, Anchor::end, true});
  }
}

/// A horizontal edge named above its left end, or below where the plot ends just above.
void add_horizontal(Figure& figure, double delta, const std::string& name) {
  if (delta > figure.y.least && delta < figure.y.most) {
    figure.curves.push_back(
        {"", {{{figure.x.least, delta}, {figure.x.most, delta}}}, Ink::grey, Dash::solid, false});
    constexpr double height = 0.07;  // of a line of words, in heights of the plot
    const double edge = figure.y.position(delta);
    const double y = edge + height < 1 ? delta : figure.y.value(edge - height);
    figure.notes.push_back({name, {figure.x.value(0.02), y}, Anchor::start});
  }
}

}  // namespace

void add_boundaries(Figure& figure, const Problem& problem, const FigureUnits& units) {
  const Region region = design::admissible_region(problem);
  FigureCurve published{"Δ₁ published", {{}}, Ink::orange, Dash::dashed};
  FigureCurve exact{"Δ₁ exact", {{}}, Ink::purple};
  for (int i = 0; i <= steps; ++i) {
    const double f = std::clamp(figure.x.value(static_cast<double>(i) / steps), 0.0, region.f3);
    published.strokes[0].push_back({f, design::delta1_published(problem, f) * units.length});
    if (const auto bound = design::delta1_exact(problem, f)) {
      exact.strokes[0].push_back({f, *bound * units.length});
    }
  }
  figure.curves.push_back(std::move(published));
  figure.curves.push_back(std::move(exact));
  add_vertical(figure, region.f3, "return: f ≤ f₃");
  add_horizontal(figure, region.delta2 * units.length, "start: Δ ≤ Δ₂");
}

Figure region_figure(const Problem& problem, const Limits& limits, const Region& region,
                     const std::optional<DrawnDamper>& damper, const FigureUnits& units) {
  constexpr double margin = 1.15;
  const double unit = units.length;
  double f_most = std::max(region.f3, std::min(region.f2, 4 * region.f3));
  double delta_most = region.delta2;
  if (damper) {
    f_most = std::max(f_most, damper->f * (1 + damper->tolerance));
    delta_most = std::max(delta_most, damper->delta * (1 + damper->tolerance));
  }
  Figure figure;
  figure.id = "region";
  figure.title = "Admissible region";
  figure.x = {"constant friction f", 0, margin * f_most};
  figure.y = {units.delta_label, 0, margin * delta_most * unit};
  figure.description = format(
      "The plane of f and Δ. Admissible is f from {:.6g} (amplitude) to {:.6g} (return) and Δ "
      "above "
      "the curve Δ₁ (stop), up to Δ₂ = {:.6g} (start); the dead zone asks for f < {:.6g}. {}",
      std::max(region.f2, 0.0), region.f3, region.delta2 * unit, region.f1,
      region.feasible ? "" : "Nothing is left: no design is admissible. ");
  if (auto outline = admissible_outline(problem, limits, region, unit); !outline.empty()) {
    figure.areas.push_back({"admissible", std::move(outline), Ink::sky});
  }
  if (damper) {
    figure.description +=
        format("{} at f = {:.6g}, Δ = {:.6g}.", damper->name, damper->f, damper->delta * unit);
    if (damper->tolerance > 0) {
      figure.areas.push_back({format("tolerance ±{:.3g} %", 100 * damper->tolerance),
                              box(*damper, unit), Ink::blue, false});
    }
    figure.marks.push_back(
        {damper->name, {{damper->f, damper->delta * unit}}, Shape::diamond, Ink::blue});
  }
  add_boundaries(figure, problem, units);
  add_vertical(figure, region.f2, "amplitude: f ≥ f₂");
  add_vertical(figure, region.f1, "dead zone: f < f₁");
  if (limits.f_max) {
    add_vertical(figure, *limits.f_max, "f max");
  }
  if (limits.delta_max) {
    add_horizontal(figure, *limits.delta_max * unit, "Δ max");
  }
  // Below the curve where the words end.
  const double words_end = std::min(0.27 * figure.x.most, 0.9 * region.f3);
  figure.notes.push_back({"stop: Δ > Δ₁",
                          {0.02 * figure.x.most, design::delta1(problem, words_end) * unit * 0.85},
                          Anchor::start});
  return figure;
}

}  // namespace stillpoint::cli
