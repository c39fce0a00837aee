// SPDX-License-Identifier: MIT
// Which part of the plane of f and Delta is enlarged.
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
