// SPDX-License-Identifier: MIT
// A damper with its tolerance in the plane of f and Delta.
#include "figures/region_figures.hpp"

namespace stillpoint::report {

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

}  // namespace stillpoint::report
