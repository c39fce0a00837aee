// SPDX-License-Identifier: MIT
// The admissible region in the plane of f and Delta.
#include "figures/lines.hpp"
#include "figures/plane.hpp"
#include "format.hpp"
#include "sections.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <optional>
#include <string_view>
#include <utility>
#include <vector>

namespace stillpoint::report {

using design::PlaneArea;
using design::PlaneKind;
using design::Problem;
using design::Region;
using figures::Dash;
using figures::Figure;
using figures::FigureAxis;
using figures::FigureCurve;
using figures::FigurePoint;
using figures::Ink;

namespace {

constexpr int along_f = 201;  // points of a curve

bool has(const std::vector<PlaneArea>& areas, PlaneKind kind) {
  return std::ranges::find(areas, kind, &PlaneArea::kind) != areas.end();
}

/// Delta1 by either formula, up to the last f that returns.
void add_delta1(Figure& figure, const Problem& problem, double last, double unit) {
  constexpr double visible = 0.005;  // of the plot above its lower edge
  const auto f = evenly(std::max(figure.x.least, 0.0), std::min(figure.x.most, last), along_f);
  const auto add = [&](std::string name, Ink ink, Dash dash, const auto& value) {
    auto strokes = line_over(f, value);
    if (std::ranges::any_of(strokes, [&](const auto& stroke) {
          return std::ranges::any_of(stroke, [&](const FigurePoint& point) {
            return figure.y.position(point.y) > visible && point.y <= figure.y.most;
          });
        })) {
      figure.curves.push_back({std::move(name), std::move(strokes), ink, dash});
    }
  };
  add("least Δ (Δ₁ published)", Ink::orange, Dash::dashed,
      [&](double at) { return std::optional(design::delta1_published(problem, at) * unit); });
  add("least Δ (Δ₁ exact)", Ink::purple, Dash::solid, [&](double at) {
    const auto bound = design::delta1_exact(problem, at);
    return bound ? std::optional(*bound * unit) : std::nullopt;
  });
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

void add_edge(Figure& figure, std::string name, FigurePoint from, FigurePoint to) {
  figure.curves.push_back(
      figures::line(std::move(name), {{from, to}}, Ink::grey, Dash::solid, true));
}

/// What the strips mean, if there are some to tell apart.
void add_strips_clauses(Figure& figure, const Problem& problem,
                        const std::vector<PlaneArea>& strips) {
  if (has(strips, PlaneKind::arrival) && (problem.arrivals > 1 || strips.size() > 1)) {
    figure.clauses.push_back(format("in a strip the mass {} at that arrival",
                                    problem.residual ? "rests within the residual" : "stops"));
  }
  if (has(strips, PlaneKind::later_arrivals)) {
    figure.clauses.emplace_back("the grey area is admissible only in thin strips");
  }
}

std::vector<std::vector<FigurePoint>> outlines(const std::vector<PlaneArea>& areas, double unit) {
  std::vector<std::vector<FigurePoint>> made;
  made.reserve(areas.size());
  for (const PlaneArea& area : areas) {
    made.push_back(outline(area, unit));
  }
  return made;
}

/// The least Delta over f under a pulse, where the mass returns.
FigureCurve needs(const design::PulseProblem& problem, double last, const FigureUnits& units) {
  const auto least_delta = design::least_delta(problem);
  return {"least Δ allowed",
          line_over(evenly(last / (along_f - 1), last, along_f - 1),
                    [&](double f) {
                      const auto least = least_delta(f);
                      return least ? std::optional(*least * units.length) : std::nullopt;
                    }),
          Ink::purple};
}

/// The far corner of what is shown of f and Delta.
FigurePoint far_corner(const DrawnRegion& drawn, double unit) {
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

design::PlaneWindow window(const Figure& figure, double unit) {
  return {{figure.x.least, figure.x.most}, {figure.y.least / unit, figure.y.most / unit}};
}

/// After a hit; the strips of the arrivals, which are its first areas.
std::vector<PlaneArea> add_plane(Figure& figure, const DrawnRegion& drawn,
                                 const FigureUnits& units) {
  const double unit = units.length.factor;
  const Region& region = drawn.region;
  const auto& damper = drawn.damper;
  const bool several = drawn.problem.arrivals > 1 || !is_plain(drawn.problem, {});
  const auto own = damper && is_within(*damper)
                       ? design::arrival_of(drawn.problem, damper->f, damper->delta)
                       : std::nullopt;
  auto strips = design::admissible_areas(drawn.problem, drawn.limits, own.value_or(0));
  Extent seen;
  for (const PlaneArea& area : strips) {
    seen.add(outline(area, unit));
  }
  Extent all = seen;
  constexpr double gap = 20;  // times f3: up to there its far end is seen
  all.add(
      {{std::max(region.f3, std::min(region.f2, gap * region.f3)), region.delta2.value() * unit}});
  constexpr double far = 1.6;  // farther out, a damper would flatten the region
  if (damper && damper->f <= far * all.most.x && damper->delta * unit <= far * all.most.y) {
    const auto box = tolerance_box(*damper, drawn.limits.shape, unit);
    seen.add(box);
    all.add(box);
  }

  figure.x = axis_of(units.f_label, seen.least.x, seen.most.x, all.most.x);
  figure.y = axis_of(units.delta_label, seen.least.y, seen.most.y, all.most.y);
  const PlaneWords words(drawn.problem, drawn.limits, units);
  add_areas(figure, strips, words, unit);
  if (drawn.problem.arrivals == 1 && strips.size() == 1) {  // no strips to tell apart
    figure.areas.front().name = region.feasible && drawn.limits.tolerance == 0
                                    ? "admissible"
                                    : "admissible without a tolerance";
    figure.areas.front().ink = Ink::sky;
  }
  const auto forbidden =
      design::forbidden_areas(drawn.problem, drawn.limits, region, window(figure, unit));
  add_areas(figure, forbidden, words, unit);
  figure.clauses = {strips.empty()
                        ? "No damper is admissible: at every f and Δ some requirement is violated"
                        : region_clause(damper, region, drawn.limits) +
                              (drawn.problem.v0_low || drawn.problem.p_high
                                   ? ", whatever the hit and the spring"
                                   : "")};
  add_strips_clauses(figure, drawn.problem, strips);
  if (!several) {
    add_delta1(figure, drawn.problem, region.f3, unit);
  }
  add_tolerant(figure, drawn.limits,
               outlines(design::tolerant_areas(drawn.problem, drawn.limits), unit));
  return strips;
}

/// Under a pulse every Delta above the curve is admissible, between the ends of f: it has no
/// strips.
std::vector<PlaneArea> add_pulse_plane(Figure& figure, const DrawnRegion& drawn,
                                       const FigureUnits& units) {
  const FigurePoint far = far_corner(drawn, units.length.factor);
  constexpr double headroom = 1.15;
  const double right = headroom * far.x;
  FigureCurve curve = needs(*drawn.pulse, right, units);
  figure.x = {units.f_label, 0, right};
  const double limit = design::largest_delta_allowed(drawn.limits) * units.length;
  figure.y = {units.delta_label, 0, headroom * topmost(curve, far.y, limit)};
  if (drawn.intervals.empty()) {
    figure.clauses = {"With every f the mass misses x = 0 or violates a limit"};
  } else {
    figure.clauses = {region_clause(drawn.damper, drawn.region, drawn.limits)};
    if (std::isinf(design::largest_delta_allowed(drawn.limits))) {
      figure.clauses.emplace_back("nothing bounds Δ from above, because the mass starts from rest");
    }
  }
  add_areas(figure,
            design::pulse_areas(*drawn.pulse, drawn.limits, drawn.region, drawn.intervals,
                                window(figure, units.length.factor)),
            PlaneWords(units.length.words(drawn.pulse->beta)), units.length.factor);
  for (figures::FigureArea& area : figure.areas) {
    const bool loose = area.name == "admissible" && drawn.limits.tolerance > 0;
    area.name += loose ? " without a tolerance" : "";
  }
  figure.curves.push_back(std::move(curve));
  if (drawn.region.feasible) {
    add_tolerant(figure, drawn.limits,
                 outlines(design::tolerant_areas(*drawn.pulse, drawn.limits, drawn.intervals,
                                                 figure.y.most / units.length.factor),
                          units.length.factor));
  }
  return {};
}

}  // namespace

void add_boundaries(Figure& figure, const Problem& problem, const FigureUnits& units,
                    const FigurePoint& last) {
  const Region region = design::admissible_region(problem);
  add_delta1(figure, problem, region.f3, units.length.factor);
  const double top = region.delta2.value() * units.length;
  if (region.f3 > figure.x.least && region.f3 < last.x) {
    add_edge(figure, "does not return →", {region.f3, figure.y.least}, {region.f3, figure.y.most});
  }
  if (top > figure.y.least && top < last.y) {
    add_edge(figure, "held ↑", {figure.x.least, top}, {figure.x.most, top});
  }
}

Figure region_figure(const DrawnRegion& drawn, const FigureUnits& units) {
  Figure figure;
  figure.id = "region";
  figure.description =
      "The plane of f and Δ: which dampers are admissible, and what forbids others. ";
  figure.title = drawn.region.feasible ? "Admissible region" : drawn.mend;
  const auto strips =
      drawn.pulse ? add_pulse_plane(figure, drawn, units) : add_plane(figure, drawn, units);
  const auto& damper = drawn.damper;
  if (damper) {
    add_damper(figure, *damper, drawn.limits.shape, units);
  }
  if (damper && strips.size() > 1) {
    add_point_inset(figure, strips, *damper, units.length.factor);
  }
  for (std::size_t i = 0; i < strips.size() && !figure.inset; ++i) {
    if (!is_seen(figure, figure.areas[i])) {
      add_strip_inset(figure, strips[i], units.length.factor);
    }
  }
  caption_inset(figure, units);
  return figure;
}

}  // namespace stillpoint::report
