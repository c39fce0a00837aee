// SPDX-License-Identifier: MIT
#include "report_figures.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <utility>
#include <vector>

namespace stillpoint::report {

using figures::Anchor;
using figures::Dash;
using figures::Figure;
using figures::FigureAxis;
using figures::FigureCurve;
using figures::FigureNote;
using figures::FigurePoint;
using figures::Ink;
using figures::Shape;

namespace {

using design::Problem;
using design::Region;
using fmt::format;

constexpr int steps = 200;  // of a curve over f

/// The f between which the region lies, tolerance aside, and the problem at each of them.
struct Span {
  double first;
  double last;
  ProblemAt at;
};

/// The arrival whose strip is drawn: that at which the damper stops the mass, else the first.
std::int64_t arrival_drawn(const DrawnRegion& drawn) {
  const auto& damper = drawn.damper;
  return damper && !drawn.pulse
             ? design::arrival_of(drawn.problem, damper->f, damper->delta).value_or(1)
             : 1;
}

Span span_of(const DrawnRegion& drawn) {
  const Region& region = drawn.region;
  if (drawn.pulse && region.f_lower) {
    const double tolerance = drawn.limits.tolerance;
    return {*region.f_lower * (1 - tolerance), *region.f_upper * (1 + tolerance),
            [pulse = *drawn.pulse](double f) { return design::problem_at(pulse, f); }};
  }
  return {
      std::max(region.f2, 0.0),
      std::min({region.f3, drawn.limits.f_max.value_or(region.f3), region.f4.value_or(region.f3)}),
      [problem = drawn.problem](double /*f*/) { return problem; }};
}

double highest_delta(const DrawnRegion& drawn, const Span& span, double f) {
  const double v0 = span.at(f).v0;
  return std::min(v0 * v0 / 2, drawn.limits.delta_max.value_or(HUGE_VAL));
}

/// The same of a later arrival, between the edges of its strip.
std::vector<FigurePoint> strip_outline(const DrawnRegion& drawn, const Span& span,
                                       std::int64_t arrival, double unit) {
  std::vector<FigurePoint> lower;
  std::vector<FigurePoint> upper;
  const double n = static_cast<double>(arrival);
  const double tip = drawn.problem.v0 * drawn.problem.p / (2 * std::sqrt(n * (n + 1)));
  const double last = std::min(span.last, tip);
  for (int i = 0; span.first <= last && i <= steps; ++i) {
    const double f = span.first + (last - span.first) * i / steps;
    const auto range = design::delta_range(drawn.problem, arrival, f);
    const double top = range ? std::min(range->high, drawn.limits.delta_max.value_or(HUGE_VAL)) : 0;
    if (range && range->low <= top) {
      lower.push_back({f, range->low * unit});
      upper.push_back({f, top * unit});
    }
  }
  if (lower.size() < 2) {
    return {};
  }
  lower.insert(lower.end(), upper.rbegin(), upper.rend());
  return lower;
}

/// What the five constraints and the limits leave, tolerance aside. Empty where that is nothing.
std::vector<FigurePoint> admissible_outline(const DrawnRegion& drawn, const Span& span,
                                            double unit) {
  std::vector<FigurePoint> lower;
  std::vector<FigurePoint> upper;
  for (int i = 0; span.first <= span.last && i <= steps; ++i) {
    const double f = span.first + (span.last - span.first) * i / steps;
    const double bound = std::max(0.0, design::delta1(span.at(f), f));
    const double top = highest_delta(drawn, span, f);
    if (bound <= top) {
      lower.push_back({f, bound * unit});
      upper.push_back({f, top * unit});
    }
  }
  if (lower.size() < 2) {
    return {};
  }
  lower.insert(lower.end(), upper.rbegin(), upper.rend());
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
  constexpr double apart = 0.01;  // from the frame
  if (figure.x.position(f) > apart && f < figure.x.most) {
    figure.curves.push_back(
        {"", {{{f, figure.y.least}, {f, figure.y.most}}}, Ink::grey, Dash::solid, false});
    figure.notes.push_back({name, {f, figure.y.value(0.985)}, Anchor::end, true});
  }
}

/// The place along x, from 0 to 1, where a name crosses no vertical edge; those are drawn before.
double free_place(const Figure& figure) {
  constexpr double length = 0.27;  // of the longest name, in widths of the plot
  for (const double place : {0.02, 0.2, 0.35, 0.5, 0.65}) {
    const bool crossed = std::ranges::any_of(figure.notes, [&](const FigureNote& note) {
      const double at = figure.x.position(note.at.x);
      return note.upright && at > place - 0.01 && at < place + length;
    });
    if (!crossed) {
      return place;
    }
  }
  return 0.02;
}

/// A horizontal edge named above, or below where the plot ends just above.
void add_horizontal(Figure& figure, double delta, const std::string& name) {
  if (delta > figure.y.least && delta < figure.y.most) {
    figure.curves.push_back(
        {"", {{{figure.x.least, delta}, {figure.x.most, delta}}}, Ink::grey, Dash::solid, false});
    constexpr double height = 0.07;  // of a line of words, in heights of the plot
    const double edge = figure.y.position(delta);
    const double y = edge + height < 1 ? delta : figure.y.value(edge - height);
    figure.notes.push_back({name, {figure.x.value(free_place(figure)), y}, Anchor::start});
  }
}

/// Delta1 by either formula, up to the last f that returns.
void add_delta1(Figure& figure, const ProblemAt& at, double last, double unit) {
  FigureCurve published{"Δ₁ published", {{}}, Ink::orange, Dash::dashed};
  FigureCurve exact{"Δ₁ exact", {{}}, Ink::purple};
  for (int i = 0; i <= steps; ++i) {
    const double f = std::clamp(figure.x.value(static_cast<double>(i) / steps), 0.0, last);
    const Problem problem = at(f);
    published.strokes[0].push_back({f, design::delta1_published(problem, f) * unit});
    if (const auto bound = design::delta1_exact(problem, f)) {
      exact.strokes[0].push_back({f, *bound * unit});
    }
  }
  figure.curves.push_back(std::move(published));
  figure.curves.push_back(std::move(exact));
}

/// From 0, but nearer where what there is to see would be small.
FigureAxis axis_of(std::string label, double least, double most, double all) {
  constexpr double margin = 1.15;
  constexpr double small = 0.25;
  constexpr double room = 0.8;  // on either side, in widths
  const double wide = most - least;
  if (!(wide > 0) || wide > small * all) {
    return {std::move(label), 0, margin * all};
  }
  return {std::move(label), std::max(0.0, least - room * wide), most + room * wide};
}

/// The least and the largest of what is to be seen.
struct Extent {
  FigurePoint least{HUGE_VAL, HUGE_VAL};
  FigurePoint most{-HUGE_VAL, -HUGE_VAL};

  void add(const std::vector<FigurePoint>& points) {
    for (const FigurePoint& at : points) {
      least = {std::min(least.x, at.x), std::min(least.y, at.y)};
      most = {std::max(most.x, at.x), std::max(most.y, at.y)};
    }
  }
};

/// The upper edge of Delta: level, but for a pulse.
void add_start(Figure& figure, const DrawnRegion& drawn, const Span& span, double unit) {
  if (!drawn.pulse) {
    return add_horizontal(figure, drawn.region.delta2 * unit, "start: Δ ≤ Δ₂");
  }
  FigureCurve start{"Δ₂", {{}}, Ink::grey};
  for (int i = 0; i <= steps; ++i) {
    const double f = span.last * i / steps;
    const double v0 = span.at(f).v0;
    start.strokes[0].push_back({f, v0 * v0 / 2 * unit});
  }
  figure.curves.push_back(std::move(start));
}

/// The edges that every arrival has.
void add_limits(Figure& figure, const DrawnRegion& drawn, double unit) {
  add_vertical(figure, drawn.region.f2, "amplitude: f ≥ f₂");
  if (drawn.limits.f_max) {
    add_vertical(figure, *drawn.limits.f_max, "f max");
  }
  if (drawn.region.f4) {
    add_vertical(figure, *drawn.region.f4, "acceleration: f ≤ f₄");
  }
  if (drawn.limits.delta_max) {
    add_horizontal(figure, *drawn.limits.delta_max * unit, "Δ max");
  }
}

void add_edges(Figure& figure, const DrawnRegion& drawn, const Span& span, double unit) {
  const double last = drawn.pulse ? span.last : drawn.region.f3;
  add_delta1(figure, span.at, last, unit);
  add_vertical(figure, last, "return: f ≤ f₃");
  add_vertical(figure, drawn.pulse ? span.first : drawn.region.f2, "amplitude: f ≥ f₂");
  add_vertical(figure, drawn.region.f1, "dead zone: f < f₁");
  if (drawn.limits.f_max) {
    add_vertical(figure, *drawn.limits.f_max, "f max");
  }
  if (drawn.region.f4) {
    add_vertical(figure, *drawn.region.f4, "acceleration: f ≤ f₄");
  }
  add_start(figure, drawn, span, unit);
  if (drawn.limits.delta_max) {
    add_horizontal(figure, *drawn.limits.delta_max * unit, "Δ max");
  }
  // Below the curve where the words end.
  const double words_end = std::min(figure.x.value(0.27), 0.9 * last);
  const double below =
      figure.y.position(design::delta1(span.at(words_end), words_end) * unit) - 0.1;
  if (below > 0 && below < 0.9) {
    figure.notes.push_back(
        {"stop: Δ > Δ₁", {figure.x.value(0.02), figure.y.value(below)}, Anchor::start});
  }
}

}  // namespace

void add_boundaries(Figure& figure, const Problem& problem, const FigureUnits& units) {
  const Region region = design::admissible_region(problem);
  add_delta1(
      figure, [&](double /*f*/) { return problem; }, region.f3, units.length);
  add_vertical(figure, region.f3, "return: f ≤ f₃");
  add_horizontal(figure, region.delta2 * units.length, "start: Δ ≤ Δ₂");
}

Figure region_figure(const DrawnRegion& drawn, const FigureUnits& units) {
  const double unit = units.length;
  const Region& region = drawn.region;
  const auto& damper = drawn.damper;
  const Span span = span_of(drawn);
  const std::int64_t arrival = arrival_drawn(drawn);
  auto outline = arrival > 1 ? strip_outline(drawn, span, arrival, unit)
                             : admissible_outline(drawn, span, unit);
  const auto tolerance_box = damper ? box(*damper, unit) : std::vector<FigurePoint>{};
  Extent seen;
  seen.add(outline);
  seen.add(tolerance_box);
  Extent all = seen;
  all.add({{std::max(region.f3, std::min(region.f2, 4 * region.f3)), region.delta2 * unit}});

  Figure figure;
  figure.id = "region";
  figure.title = "Admissible region";
  figure.x = axis_of("constant friction f", seen.least.x, seen.most.x, all.most.x);
  figure.y = axis_of(units.delta_label, seen.least.y, seen.most.y, all.most.y);
  const double last = drawn.pulse ? span.last : region.f3;
  figure.description = format(
      "The plane of f and Δ. The admissible region goes from f = {:.6g} (amplitude) to {:.6g} "
      "(return) and from the curve Δ₁ (stop) up to Δ₂ = {:.6g} (start); the dead zone requires "
      "f < {:.6g}. {}",
      drawn.pulse ? span.first : std::max(region.f2, 0.0), last, region.delta2 * unit, region.f1,
      region.feasible ? "" : "Nothing is left: no design is admissible. ");
  if (arrival > 1) {
    figure.title = format("Admissible region of arrival {}", arrival);
    figure.description = format(
        "The plane of f and Δ. The strip in which the mass stops at x = 0 at arrival {}, within "
        "the "
        "limits. ",
        arrival);
  } else if (drawn.problem.arrivals > 1) {
    figure.title += " of the first arrival";
  }
  if (!outline.empty()) {
    figure.areas.push_back({arrival > 1 ? format("admissible, arrival {}", arrival) : "admissible",
                            std::move(outline), Ink::sky});
  }
  if (damper) {
    figure.description +=
        format("{} at f = {:.6g}, Δ = {:.6g}.", damper->name, damper->f, damper->delta * unit);
    if (damper->tolerance > 0) {
      figure.areas.push_back({format("tolerance ±{:.3g} %", 100 * damper->tolerance), tolerance_box,
                              Ink::blue, false});
    }
    figure.marks.push_back(
        {damper->name, {{damper->f, damper->delta * unit}}, Shape::diamond, Ink::blue});
  }
  if (arrival > 1) {
    add_limits(figure, drawn, unit);
  } else {
    add_edges(figure, drawn, span, unit);
  }
  return figure;
}

}  // namespace stillpoint::report
