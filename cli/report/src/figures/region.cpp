// SPDX-License-Identifier: MIT
#include "figures/region_column.hpp"
#include "figures/report_figures.hpp"
#include "format.hpp"
#include "sections.hpp"

#include <stillpoint/records/decimal.hpp>
#include <stillpoint/report/digits.hpp>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <string_view>
#include <utility>
#include <vector>

namespace stillpoint::report {

using figures::AreaLook;
using figures::Dash;
using figures::Figure;
using figures::FigureArea;
using figures::FigureAxis;
using figures::FigureCurve;
using figures::FigurePoint;
using figures::Ink;
using figures::Shape;

namespace {

using design::Problem;
using design::Region;

constexpr int steps = 200;  // of a curve over f

/// Delta1 by either formula, up to the last f that returns.
void add_delta1(Figure& figure, const Problem& problem, double last, double unit) {
  constexpr double visible = 0.005;  // of the plot above its lower edge
  FigureCurve published{"least Δ (Δ₁ published)", {{}}, Ink::orange, Dash::dashed};
  FigureCurve exact{"least Δ (Δ₁ exact)", {{}}, Ink::purple};
  for (int i = 0; i <= steps; ++i) {
    const double f = std::clamp(figure.x.value(static_cast<double>(i) / steps), 0.0, last);
    published.strokes[0].push_back({f, design::delta1_published(problem, f) * unit});
    if (const auto bound = design::delta1_exact(problem, f)) {
      exact.strokes[0].push_back({f, *bound * unit});
    }
  }
  for (FigureCurve* const curve : {&published, &exact}) {
    if (std::ranges::any_of(curve->strokes[0], [&](const FigurePoint& point) {
          return figure.y.position(point.y) > visible && point.y <= figure.y.most;
        })) {
      figure.curves.push_back(std::move(*curve));
    }
  }
}

/// From 0, but closer if the interesting part would be small.
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

/// A part of the plane is enlarged in a corner, unless rounding would be seen.
void add_inset(Figure& figure, const FigurePoint& low, const FigurePoint& high) {
  constexpr double least_numbers = 1e-9;
  constexpr double room = 0.6;  // on either side
  const double wide = high.x - low.x;
  const double tall = high.y - low.y;
  if (wide > least_numbers * high.x && tall > least_numbers * high.y) {
    figure.inset = {{"", std::max(figure.x.least, low.x - room * wide), high.x + room * wide},
                    {"", std::max(figure.y.least, low.y - room * tall), high.y + room * tall}};
  }
}

/// Of a strip too thin to see, where it is thickest. The legend names it.
void add_strip_inset(Figure& figure, const FigureArea& strip) {
  const std::vector<FigurePoint>& outline = strip.outline;
  const std::size_t last = outline.size() - 1;  // the upper edge comes back above the lower one
  std::size_t thickest = 0;
  for (std::size_t i = 0; i <= last / 2; ++i) {
    if (outline[last - i].y - outline[i].y > outline[last - thickest].y - outline[thickest].y) {
      thickest = i;
    }
  }
  FigurePoint low = outline[thickest];
  FigurePoint high = outline[last - thickest];
  for (const FigurePoint& at : outline) {
    if (outline[thickest].y <= at.y && at.y <= outline[last - thickest].y) {
      low.x = std::min(low.x, at.x);
      high.x = std::max(high.x, at.x);
    }
  }
  add_inset(figure, low, high);
}

/// Of a point whose mark would hide the strip, or the gap between strips, that it lies in.
void add_point_inset(Figure& figure, const Problem& problem, const DrawnDamper& damper,
                     double unit) {
  constexpr double hidden = 0.06;  // of the plot
  const RegionColumn column = region_column(problem, damper.f);
  Interval around{column.stop, HUGE_VAL};
  for (const auto& strip : column.strips) {
    for (const double edge : strip ? std::vector{strip->low, strip->high} : std::vector<double>{}) {
      (edge <= damper.delta ? around.low : around.high) =
          edge <= damper.delta ? std::max(around.low, edge) : std::min(around.high, edge);
    }
  }
  const double tall = (around.high - around.low) * unit;
  if (!figure.inset && around.low <= damper.delta &&
      tall < hidden * (figure.y.most - figure.y.least)) {
    const double half = hidden / 2 * (figure.x.most - figure.x.least);
    add_inset(figure, {std::max(damper.f - half, figure.x.least), around.low * unit},
              {damper.f + half, around.high * unit});
  }
}

void add_edge(Figure& figure, std::string name, FigurePoint from, FigurePoint to) {
  figure.curves.push_back({.name = std::move(name),
                           .strokes = {{from, to}},
                           .ink = Ink::grey,
                           .hover = false,
                           .labelled = true});
}

/// The strips of later arrivals lie below those of earlier ones.
std::string caption_of(const DrawnRegion& drawn, const std::vector<FigureArea>& strips_drawn,
                       const FigureUnits& units) {
  const Problem& problem = drawn.problem;
  const std::size_t areas = strips_drawn.size();
  const auto is_of_arrival = [](const FigureArea& area) {
    return area.name.starts_with("arrival ");
  };
  const bool any_rest = problem.residual && !is_of_arrival(strips_drawn.front());
  const std::string strips =
      is_one_area(problem, areas) || std::ranges::none_of(strips_drawn, is_of_arrival)
          ? ""
          : format("; in {} strip{} the mass {} at that arrival{}{}", any_rest ? "the" : "each",
                   any_rest ? " of an arrival" : "",
                   problem.residual ? "rests within the residual" : "stops at x = 0",
                   areas > 1 && !problem.residual ? ", in a lower strip at a later one" : "",
                   std::ranges::any_of(strips_drawn, has_gaps)
                       ? "; the grey area is admissible only in thin strips"
                       : "");
  const std::string_view ranges = problem.v0_low && problem.p_high
                                      ? " with every hit and spring of the ranges"
                                  : problem.v0_low ? " with every hit of the range"
                                  : problem.p_high ? " with every spring of the range"
                                                   : "";
  return format("{}{}{}.", region_clause(drawn.damper, drawn.region, drawn.limits, units), ranges,
                strips);
}

/// Without any admissible damper.
std::string empty_caption(const Figure& figure) {
  const auto has = [&figure](std::string_view gap) {
    return std::ranges::any_of(
        figure.areas, [gap](const FigureArea& area) { return area.name.starts_with(gap); });
  };
  return format("No damper is admissible: {}.",
                has("gap: no f")       ? "in the gap f is both too weak and too strong"
                : has("gap: no notch") ? "in the gap even the largest Δ is too weak"
                : has("gap: too weak") ? "in the gap f is too weak and already beyond a limit"
                                       : "at every f and Δ some requirement is violated");
}

std::string plane_words(const Region& region, const FigureUnits& units) {
  return format(
      "The plane of f and Δ. The admissible region goes from f = {:.4g} (amplitude) to {:.4g} "
      "(return) and from the curve Δ₁ (stop) up to Δ₂ = {} (start); the dead zone requires "
      "f < {:.4g}. {}",
      std::max(region.f2, 0.0), region.f3, units.length_words(region.delta2.value()), region.f1,
      region.feasible ? "" : "Nothing is left: no design is admissible. ");
}

/// In so few digits that it still lies well within its box.
std::string within_box(double value, double tolerance) {
  constexpr double well = 0.1;
  constexpr int fewest = 4;
  constexpr int every = 17;  // that a double has
  int shown = fewest;
  while (shown < every &&
         std::abs(records::decimal(value, shown) - value) > well * tolerance * value) {
    ++shown;
  }
  return shown == fewest ? few_digits(value) : format("{:.{}g}", value, shown);
}

/// "±34.2 %", or "-10 to +20 %" where the sides differ.
std::string percent(double low, double high) {
  const std::string above = percent_digits(high);
  const std::string below = percent_digits(low);
  return low == high ? "±" + above : format("-{} to +{}", below.substr(0, below.find(' ')), above);
}

}  // namespace

void caption_inset(Figure& figure, const FigureUnits& units) {
  if (figure.inset) {
    const auto& [x, y] = *figure.inset;
    figure.caption.pop_back();
    figure.caption +=
        format("; the corner enlarges f of {} and Δ of {}{}.", interval_digits(x.least, x.most),
               interval_digits(y.least, y.most), with_blank(units.length_unit));
  }
}

void add_box_inset(Figure& figure, const std::vector<FigurePoint>& box) {
  constexpr double visible = 0.05;          // of the plot
  constexpr double next_to_nothing = 1e-6;  // of the axis
  const bool small = box[2].x - box[0].x < visible * (figure.x.most - figure.x.least) ||
                     box[2].y - box[0].y < visible * (figure.y.most - figure.y.least);
  if (small && box[2].x > next_to_nothing * figure.x.most) {
    add_inset(figure, box[0], box[2]);
  }
}

std::vector<FigurePoint> tolerance_box(const DrawnDamper& damper, const design::BoxShape& shape,
                                       double unit) {
  const double r = damper.tolerance;
  const double delta = damper.delta * unit;
  const double left = damper.f * (1 - r * shape.f_low);
  const double right = damper.f * (1 + r * shape.f_high);
  const double bottom = delta * (1 - r * shape.delta_low);
  const double top = delta * (1 + r * shape.delta_high);
  return {{left, bottom}, {right, bottom}, {right, top}, {left, top}};
}

std::string tolerance_words(const design::BoxShape& shape, double tolerance) {
  const std::string f = percent(tolerance * shape.f_low, tolerance * shape.f_high);
  return shape == design::BoxShape{}
             ? "tolerance " + f
             : format("tolerance: f {}, Δ {}", f,
                      percent(tolerance * shape.delta_low, tolerance * shape.delta_high));
}

std::string region_clause(const std::optional<DrawnDamper>& damper, const Region& region,
                          const design::Limits& limits, const FigureUnits& units) {
  if (damper && is_within(*damper)) {
    if (!leaves_any(damper->tolerance)) {
      return "f or Δ must be exact: the damper is within a millionth of an edge of the admissible "
             "region";
    }
    const auto& [f_low, f_high, delta_low, delta_high] = limits.shape;
    const std::string delta =
        format("Δ = {}{}", within_box(damper->delta * units.length, damper->tolerance),
               with_blank(units.length_unit));
    const std::string f = "f = " + within_box(damper->f, damper->tolerance);
    const bool exact_f = f_low + f_high == 0;
    return exact_f || begins_at_nothing(damper->f, region.f_upper.value_or(0))
               ? format("The box shows how far {} may be off{}", delta,
                        exact_f ? ", with f exactly as given" : "")
           : delta_low + delta_high == 0
               ? format("The box shows how far {} may be off, with Δ exactly as given", f)
               : format("The box shows how far {} and {} may both be off", f, delta);
  }
  if (limits.tolerance > 0 && region.feasible) {
    return "A damper inside the dotted line keeps the tolerance asked for";
  }
  return format("A damper in the area without hatching is admissible{}",
                limits.tolerance > 0 ? " without the tolerance asked for" : "");
}

void add_tolerant(Figure& figure, const design::Limits& limits,
                  std::vector<std::vector<FigurePoint>> areas) {
  std::erase_if(areas, [](const auto& area) { return area.empty(); });
  if (areas.empty()) {
    return;
  }
  for (std::vector<FigurePoint>& area : areas) {
    area.push_back(area.front());
  }
  figure.curves.push_back({.name = tolerance_words(limits.shape, limits.tolerance) + " asked for",
                           .strokes = std::move(areas),
                           .ink = Ink::blue,
                           .dash = Dash::dotted,
                           .hover = false});
}

void add_damper(Figure& figure, const DrawnDamper& damper, const design::BoxShape& shape,
                const FigureUnits& units) {
  const FigurePoint at{damper.f, damper.delta * units.length};
  const std::string values =
      format("f = {:.4g}, Δ = {}", damper.f, units.length_words(damper.delta));
  figure.description += damper.name + " at " + values;
  if (leaves_any(damper.tolerance)) {
    const std::string words = tolerance_words(shape, damper.tolerance);
    auto box = tolerance_box(damper, shape, units.length);
    add_box_inset(figure, box);
    if (begins_at_nothing(box[2].x, figure.x.most)) {  // a line along the axis would not be seen
      constexpr double visible = 0.012;                // of the axis
      box[1].x = box[2].x = visible * figure.x.most;
    }
    figure.areas.push_back({words, box, Ink::blue, AreaLook::box});
    figure.description += ", " + words;
  }
  figure.description += ".";
  figure.marks.push_back(
      {damper.name, {at}, Shape::diamond, damper.admissible ? Ink::blue : Ink::orange});
  if (figure.x.position(at.x) > 1 || figure.y.position(at.y) > 1) {
    figure.marks.back().name = damper.name + ": " + values;
    figure.caption = "The arrow points to the damper, which lies far outside this figure.";
  }
}

void add_boundaries(Figure& figure, const Problem& problem, const FigureUnits& units,
                    const FigurePoint& last) {
  const Region region = design::admissible_region(problem);
  add_delta1(figure, problem, region.f3, units.length);
  const double top = region.delta2.value() * units.length;
  if (region.f3 > figure.x.least && region.f3 < last.x) {
    add_edge(figure, "does not return →", {region.f3, figure.y.least}, {region.f3, figure.y.most});
  }
  if (top > figure.y.least && top < last.y) {
    add_edge(figure, "held ↑", {figure.x.least, top}, {figure.x.most, top});
  }
}

Figure region_figure(const DrawnRegion& drawn, const FigureUnits& units) {
  const double unit = units.length;
  const Region& region = drawn.region;
  const auto& damper = drawn.damper;
  const bool several = drawn.problem.arrivals > 1 || !is_plain(drawn.problem, {});
  const auto admissible = admissible_areas(drawn, units);
  const design::BoxShape& shape = drawn.limits.shape;
  const auto box = damper ? tolerance_box(*damper, shape, unit) : std::vector<FigurePoint>{};
  Extent seen;
  for (const FigureArea& area : admissible) {
    seen.add(area.outline);
  }
  Extent all = seen;
  constexpr double gap = 20;  // times f3: up to there its far end is seen
  all.add(
      {{std::max(region.f3, std::min(region.f2, gap * region.f3)), region.delta2.value() * unit}});
  constexpr double far = 1.6;  // farther out, a damper would flatten the region
  if (damper && damper->f <= far * all.most.x && damper->delta * unit <= far * all.most.y) {
    seen.add(box);
    all.add(box);
  }

  Figure figure;
  figure.id = "region";
  figure.title = region.feasible ? "Admissible region" : drawn.mend;
  figure.x = axis_of("constant friction f", seen.least.x, seen.most.x, all.most.x);
  figure.y = axis_of(units.delta_label, seen.least.y, seen.most.y, all.most.y);
  figure.description =
      several ? "The plane of f and Δ with the strip of each arrival at which the mass may rest. "
              : plane_words(region, units);
  figure.areas = admissible;
  const std::size_t strips = admissible.size();
  add_sides(figure, drawn, units);
  figure.caption = strips > 0 ? caption_of(drawn, admissible, units) : empty_caption(figure);
  if (!several) {
    add_delta1(figure, drawn.problem, region.f3, unit);
  }
  add_tolerant(figure, drawn.limits, tolerant_areas(drawn, unit));
  if (damper) {
    add_damper(figure, *damper, shape, units);
  }
  if (damper && strips > 1) {
    add_point_inset(figure, drawn.problem, *damper, unit);
  }
  for (std::size_t i = 0; i < strips && !figure.inset; ++i) {
    if (!is_seen(figure, figure.areas[i])) {
      add_strip_inset(figure, figure.areas[i]);
    }
  }
  caption_inset(figure, units);
  return figure;
}

}  // namespace stillpoint::report
