// SPDX-License-Identifier: MIT
// The admissible region in the plane of f and Delta.
#include "choices.hpp"
#include "figures/region_figures.hpp"

namespace stillpoint::report {

using design::PlaneArea;
using design::PlaneKind;
using design::Problem;
using design::Region;

namespace {

constexpr int along_f = 201;  // points of a curve

/// Delta1 by either formula, up to the last f that returns.
void add_delta1(Figure& figure, const Problem& problem, double last, double unit) {
  constexpr double visible = 0.005;  // of the plot above its lower edge
  const auto f = evenly(std::max(figure.x.least, 0.0), std::min(figure.x.most, last), along_f);
  const auto add = [&](std::string name, Ink ink, Dash dash, const auto& value) {
    auto strokes = line_over(f, unit, value);
    if (std::ranges::any_of(joined(strokes), [&](const FigurePoint& point) {
          return figure.y.position(point.y) > visible && point.y <= figure.y.most;
        })) {
      figure.curves.push_back({std::move(name), std::move(strokes), ink, dash});
    }
  };
  add("least Δ (Δ₁ published)", Ink::orange, Dash::dashed,
      [&](double at) { return design::delta1_published(problem, at); });
  add("least Δ (Δ₁ exact)", Ink::purple, Dash::solid,
      [&](double at) { return design::delta1_exact(problem, at); });
}

void append(Points& points, const Points& more) {
  points.insert(points.end(), more.begin(), more.end());
}

double most(const Points& points, double FigurePoint::*along) {
  return std::ranges::max(points, {}, along).*along;
}

/// From 0 to the farthest of all, but closer if what is seen, the interesting part, would be small.
FigureAxis axis_of(std::string label, const Points& seen, const Points& all,
                   double FigurePoint::*along) {
  constexpr double margin = 1.15;
  constexpr double small = 0.25;
  constexpr double room = 0.8;  // on either side, in widths
  const double far = most(all, along);
  const double high = seen.empty() ? 0 : most(seen, along);
  const double low = seen.empty() ? 0 : std::ranges::min(seen, {}, along).*along;
  const double wide = high - low;
  return !(wide > 0) || wide > small * far
             ? FigureAxis{std::move(label), 0, margin * far}
             : FigureAxis{std::move(label), std::max(0.0, low - room * wide), high + room * wide};
}

/// The figure while it is drawn.
struct RegionFigure : ShownTask {
  const Region& region;
  const std::optional<DrawnDamper>& damper;
  FigureUnits units;
  Figure figure;
  double unit{units.length.factor};  ///< that Delta has on the axis
  std::vector<PlaneArea> strips{};   ///< of the arrivals, its first areas

  void add(const std::vector<PlaneArea>& areas) { add_areas(figure, areas, *this, units); }

  /// A line around each of the areas in which a damper keeps the tolerance asked for.
  void add_tolerant(const std::vector<PlaneArea>& areas) {
    Strokes lines;
    for (const PlaneArea& area : areas) {
      if (!area.columns.empty()) {
        lines.push_back(outline(area, unit));
        lines.back().push_back(lines.back().front());
      }
    }
    if (!lines.empty()) {
      figure.add_line(tolerance_words(limits.shape, limits.tolerance) + " asked for",
                      std::move(lines), Ink::blue, Dash::dotted);
    }
  }

  [[nodiscard]] design::PlaneWindow window() const {
    return {{figure.x.least, figure.x.most}, {figure.y.least / unit, figure.y.most / unit}};
  }

  /// Whether the damper is in the region, even if it keeps less than the tolerance asked for.
  [[nodiscard]] bool is_within() const {
    return damper && (damper->admissible || damper->tolerance > 0);
  }

  /// What the box means, or without one the area that is left.
  [[nodiscard]] std::string clause() const {
    if (!is_within()) {
      return limits.tolerance > 0 && region.feasible
                 ? "A damper inside the dotted line keeps the tolerance asked for"
                 : format("A damper in the area without hatching is admissible{}",
                          limits.tolerance > 0 ? " without the tolerance asked for" : "");
    }
    if (!leaves_any(damper->tolerance)) {
      return "f or Δ must be exact: the damper is within a millionth of an edge of the admissible "
             "region";
    }
    return "The box shows how far f and Δ may be off";
  }

  /// After a hit.
  void add_plane() {
    const auto own =
        is_within() ? design::arrival_of(problem, damper->f, damper->delta) : std::nullopt;
    strips = design::admissible_areas(problem, limits, own.value_or(0));
    Points seen;
    for (const PlaneArea& area : strips) {
      append(seen, outline(area, unit));
    }
    Points all = seen;
    constexpr double gap = 20;  // times f3: up to there its far end is seen
    all.push_back(
        {std::max(region.f3, std::min(region.f2, gap * region.f3)), region.delta2.value() * unit});
    constexpr double far = 1.6;  // farther out, a damper would flatten the region
    if (damper && damper->f <= far * most(all, &FigurePoint::x) &&
        damper->delta * unit <= far * most(all, &FigurePoint::y)) {
      const Points box = tolerance_box(*damper, limits.shape, unit);
      append(seen, box);
      append(all, box);
    }
    figure.x = axis_of(units.f_label, seen, all, &FigurePoint::x);
    figure.y = axis_of(units.delta_label, seen, all, &FigurePoint::y);
    add(strips);
    if (problem.arrivals == 1 && strips.size() == 1) {  // no strips to tell apart
      figure.areas.front().name = region.feasible && limits.tolerance == 0
                                      ? "admissible"
                                      : "admissible without a tolerance";
      figure.areas.front().ink = Ink::sky;
    }
    add(design::forbidden_areas(problem, limits, region, window()));
    figure.clauses = {strips.empty()
                          ? "No damper is admissible: at every f and Δ some requirement is violated"
                          : clause() + (problem.v0_low || problem.p_high
                                            ? ", whatever the hit and the spring"
                                            : "")};
    const auto any = [&](PlaneKind kind) {
      return std::ranges::find(strips, kind, &PlaneArea::kind) != strips.end();
    };
    if (any(PlaneKind::arrival) && (problem.arrivals > 1 || strips.size() > 1)) {
      figure.clauses.push_back(format("in a strip the mass {} at that arrival",
                                      problem.residual ? "rests within the residual" : "stops"));
    }
    if (any(PlaneKind::later_arrivals)) {
      figure.clauses.emplace_back("the grey area is admissible only in thin strips");
    }
    if (problem.arrivals == 1 && is_plain(problem, {})) {
      add_delta1(figure, problem, region.f3, unit);
    }
    add_tolerant(design::tolerant_areas(problem, limits));
  }

  /// Under a pulse every Delta above the curve is admissible, between the ends of f: it has no
  /// strips.
  void add_pulse_plane(const std::vector<Interval>& intervals) {
    constexpr double headroom = 1.15;
    const auto posed = pulse_problem(problem, *pulse, ranges);
    Points seen{{std::max(region.f3, intervals.empty() ? 0 : intervals.back().high), 0}};
    if (damper) {
      append(seen, tolerance_box(*damper, limits.shape, unit));
    }
    const double right = headroom * most(seen, &FigurePoint::x);
    Strokes needs = line_over(evenly(right / (along_f - 1), right, along_f - 1), unit,
                              design::least_delta(posed));
    append(seen, joined(needs));
    constexpr double far = 1.5;  // from there on a limit would flatten the curve
    const double limit = design::largest_delta_allowed(limits) * unit;
    const double top = most(seen, &FigurePoint::y);
    figure.x = {units.f_label, 0, right};
    figure.y = {units.delta_label, 0, headroom * (limit < far * top ? std::max(top, limit) : top)};
    figure.clauses = {intervals.empty() ? "With every f the mass misses x = 0 or violates a limit"
                                        : clause()};
    if (!intervals.empty() && std::isinf(limit)) {
      figure.clauses.emplace_back("nothing bounds Δ from above, because the mass starts from rest");
    }
    add(design::pulse_areas(posed, limits, region, intervals, window()));
    for (FigureArea& area : figure.areas) {
      const bool loose = area.name == "admissible" && limits.tolerance > 0;
      area.name += loose ? " without a tolerance" : "";
    }
    figure.curves.push_back({"least Δ allowed", std::move(needs), Ink::purple});
    if (region.feasible) {
      add_tolerant(design::tolerant_areas(posed, limits, intervals, figure.y.most / unit));
    }
  }
};

}  // namespace

bool add_boundaries(Figure& figure, const Problem& problem, const FigureUnits& units,
                    const FigurePoint& last) {
  const Region region = design::admissible_region(problem);
  add_delta1(figure, problem, region.f3, units.length.factor);
  const bool seen = !figure.curves.empty();
  const double top = region.delta2.value() * units.length;
  if (region.f3 > figure.x.least && region.f3 < last.x) {
    figure.add_line("does not return →", {figure.upright(region.f3)}, Ink::grey, Dash::solid, true);
  }
  if (top > figure.y.least && top < last.y) {
    figure.add_line("held ↑", {figure.level(top)}, Ink::grey, Dash::solid, true);
  }
  return seen;
}

Figure region_figure(const ShownTask& task, const design::RegionVerdict& verdict,
                     const std::optional<DrawnDamper>& damper,
                     const std::optional<Catalogue>& catalogue) {
  RegionFigure drawn{
      task,
      verdict.region,
      damper,
      units_of(task.physical),
      {"region",
       verdict.region.feasible ? "Admissible region"
       : catalogue             ? "No part is admissible"
                               : "No damper is admissible",
       "The plane of f and Δ: which dampers are admissible, and what forbids others. "}};
  Figure& figure = drawn.figure;
  if (task.pulse) {
    drawn.add_pulse_plane(*verdict.intervals);
  } else {
    drawn.add_plane();
  }
  if (damper) {
    add_damper(figure, *damper, task.limits.shape, drawn.units);
  }
  add_inset(figure, drawn.strips, damper, drawn.units);
  if (catalogue) {
    add_parts(figure, *catalogue, drawn.units);
  }
  return std::move(figure);
}

}  // namespace stillpoint::report
