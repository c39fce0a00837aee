// SPDX-License-Identifier: MIT
#include "figure_words.hpp"

namespace stillpoint::figures {

Ground::Ground(const Figure& drawn, const Plane& plot)
    : figure(drawn), plane(plot), ink(plot.width, plot.height), taken(plot.width, plot.height) {
  for (const FigureCurve& curve : figure.curves) {
    for (const auto& stroke : curve.strokes) {
      const auto line = plane.pixels(stroke);
      ink.set_line(line);
      if (curve.labelled || !curve.hover) {
        others.push_back(line);
        if (!figure.map.cells.empty()) {
          taken.set_line(line);
        }
      }
    }
  }
  for (const FigureArea& area : figure.areas) {
    if (area.look == AreaLook::filled || area.look == AreaLook::box) {  // others have no edge
      auto outline = plane.pixels(area.outline);
      outline.push_back(outline.front());
      ink.set_line(outline);
    }
  }
  constexpr double mark = 12;
  for (const FigureMarks& marks : figure.marks) {
    for (const FigurePoint& at : marks.points) {
      taken.set(box_around(at_frame(plane, at), mark, mark));
    }
  }
}

bool Ground::is_free(const Box& box) const {
  constexpr double edge = 2;  // pixels of the plot
  return box.left >= edge && box.top >= edge && box.right <= plane.width - edge &&
         box.bottom <= plane.height - edge && taken.set_in(box) == 0;
}

FigurePoint at_frame(const Plane& plane, const FigurePoint& at) {
  constexpr double apart = 10;
  const auto [x, y] = plane.pixel(at);
  return plane.holds(at) ? FigurePoint{x, y}
                         : FigurePoint{std::clamp(x, apart, plane.width - apart),
                                       std::clamp(y, apart, plane.height - apart)};
}

}  // namespace stillpoint::figures
