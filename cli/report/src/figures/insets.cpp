// SPDX-License-Identifier: MIT
// Which part of the plane of f and Delta is enlarged.
#include "figures/region_figures.hpp"
#include "sections.hpp"

namespace stillpoint::report {

using design::PlaneArea;

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

void caption_inset(Figure& figure, const FigureUnits& units) {
  if (figure.inset) {
    const auto& [x, y] = *figure.inset;
    figure.clauses.push_back(
        format("the corner enlarges f of {} and Δ of {}{}", interval_digits(x.least, x.most),
               interval_digits(y.least, y.most), with_blank(units.length.name)));
  }
}

void add_box_inset(Figure& figure, const Points& box) {
  constexpr double visible = 0.05;          // of the plot
  constexpr double next_to_nothing = 1e-6;  // of the axis
  const bool small = box[2].x - box[0].x < visible * (figure.x.most - figure.x.least) ||
                     box[2].y - box[0].y < visible * (figure.y.most - figure.y.least);
  if (small && box[2].x > next_to_nothing * figure.x.most) {
    add_inset(figure, box[0], box[2]);
  }
}

void add_strip_inset(Figure& figure, const PlaneArea& strip, double unit) {
  const auto [f, delta] = design::thickest_part(strip);
  add_inset(figure, {f.low, delta.low * unit}, {f.high, delta.high * unit});
}

void add_point_inset(Figure& figure, const std::vector<PlaneArea>& areas, const DrawnDamper& damper,
                     double unit) {
  constexpr double hidden = 0.06;  // of the plot
  const Interval around = design::edges_about(areas, damper.f, damper.delta);
  const double tall = (around.high - around.low) * unit;
  if (!figure.inset && tall < hidden * (figure.y.most - figure.y.least)) {
    const double half = hidden / 2 * (figure.x.most - figure.x.least);
    add_inset(figure, {std::max(damper.f - half, figure.x.least), around.low * unit},
              {damper.f + half, around.high * unit});
  }
}

}  // namespace stillpoint::report
