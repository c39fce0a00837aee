// SPDX-License-Identifier: MIT
// A damper with its tolerance in the plane of f and Delta.
#include "figures/region_figures.hpp"

namespace stillpoint::report {

using design::PlaneArea;

namespace {

/// A part of the plane in a corner, unless rounding would be seen.
void enlarge(Figure& figure, const FigurePoint& low, const FigurePoint& high) {
  constexpr double least_numbers = 1e-9;
  constexpr double room = 0.6;  // on either side
  const double wide = high.x - low.x;
  const double tall = high.y - low.y;
  if (wide > least_numbers * high.x && tall > least_numbers * high.y) {
    figure.inset = {{"", std::max(figure.x.least, low.x - room * wide), high.x + room * wide},
                    {"", std::max(figure.y.least, low.y - room * tall), high.y + room * tall}};
  }
}

}  // namespace

Points tolerance_box(const DrawnDamper& damper, const design::BoxShape& shape, double unit) {
  const auto& [f, delta] = box_about({damper.f, damper.delta * unit, damper.tolerance}, shape);
  return rectangle(f.low, f.high, delta.low, delta.high);
}

std::string tolerance_words(const design::BoxShape& shape, double tolerance) {
  return shape == design::BoxShape{}
             ? "tolerance ±" + percent_digits(tolerance)
             : "tolerance: " + sides_text(shape, tolerance, usual_digits, "Δ", "±");
}

void add_damper(Figure& figure, const DrawnDamper& damper, const design::BoxShape& shape,
                const FigureUnits& units) {
  const FigurePoint at{damper.f, damper.delta * units.length};
  const std::string values =
      format("f = {:.4g}, Δ = {}", damper.f, units.length.words(damper.delta));
  figure.description += damper.name + " at " + values;
  if (leaves_any(damper.tolerance)) {
    const std::string words = tolerance_words(shape, damper.tolerance);
    auto box = tolerance_box(damper, shape, units.length.factor);
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
    figure.clauses = {"The arrow points to the damper, which lies far outside this figure"};
  }
}

void add_box_inset(Figure& figure, const Points& box) {
  constexpr double visible = 0.05;          // of the plot
  constexpr double next_to_nothing = 1e-6;  // of the axis
  const bool small = box[2].x - box[0].x < visible * (figure.x.most - figure.x.least) ||
                     box[2].y - box[0].y < visible * (figure.y.most - figure.y.least);
  if (small && box[2].x > next_to_nothing * figure.x.most) {
    enlarge(figure, box[0], box[2]);
  }
}

void add_inset(Figure& figure, const std::vector<PlaneArea>& strips,
               const std::optional<DrawnDamper>& damper, const FigureUnits& units) {
  constexpr double hidden = 0.06;  // of the plot, by the mark of a damper
  const Unit& unit = units.length;
  if (damper && strips.size() > 1 && !figure.inset) {
    const auto [low, high] = design::edges_about(strips, damper->f, damper->delta);
    if ((high - low) * unit < hidden * (figure.y.most - figure.y.least)) {
      const double half = hidden / 2 * (figure.x.most - figure.x.least);
      enlarge(figure, {std::max(damper->f - half, figure.x.least), low * unit},
              {damper->f + half, high * unit});
    }
  }
  for (std::size_t i = 0; i < strips.size() && !figure.inset; ++i) {
    if (!is_seen(figure, figure.areas[i])) {
      const auto [f, delta] = design::thickest_part(strips[i]);
      enlarge(figure, {f.low, delta.low * unit}, {f.high, delta.high * unit});
    }
  }
  if (figure.inset) {
    const auto& [x, y] = *figure.inset;
    figure.clauses.push_back(format("the corner enlarges f of {} and Δ of {}{}",
                                    interval_digits(x.least, x.most),
                                    interval_digits(y.least, y.most), with_blank(unit.name)));
  }
}

}  // namespace stillpoint::report
