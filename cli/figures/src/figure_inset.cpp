// SPDX-License-Identifier: MIT
#include "figure_looks.hpp"
#include "figure_parts.hpp"
#include "figure_words.hpp"

namespace stillpoint::figures {

namespace {

/// The part that is enlarged.
Box enlarged(const Figure& figure, const Plane& plot) {
  const auto& [x, y] = *figure.inset;
  const FigurePoint low = plot.pixel({x.least, y.least});
  const FigurePoint high = plot.pixel({x.most, y.most});
  return {low.x, high.y, high.x, low.y};
}

}  // namespace

Box place_inset(Ground& ground) {
  constexpr double covering = 8;  // pixels farther away, a cell covered
  constexpr double hiding = 50;   // the same for a cell of a mark
  constexpr double part = 0.36;   // of the plot
  constexpr double edge = 8;
  const double wide = part * ground.plane.width;
  const double high = part * ground.plane.height;
  const Box small = enlarged(ground.figure, ground.plane);
  const FigurePoint middle{(small.left + small.right) / 2, (small.top + small.bottom) / 2};
  FigurePoint best;
  double least = HUGE_VAL;
  for (const double x : {ground.plane.width - wide / 2 - edge, wide / 2 + edge}) {
    for (const double y : {high / 2 + edge, ground.plane.height - high / 2 - edge}) {
      const Box box = box_around({x, y}, wide, high);
      const double cost = covering * ground.ink.set_in(box) + hiding * ground.taken.set_in(box) -
                          std::hypot(x - middle.x, y - middle.y);
      if (cost < least) {
        least = cost;
        best = {x, y};
      }
    }
  }
  ground.taken.set(box_around(best, wide, high));
  ground.taken.set(box_around(middle, 14, 14));
  Points edge_of_small = rectangle(small.left, small.right, small.bottom, small.top);
  edge_of_small.push_back(edge_of_small.front());
  ground.ink.set_line(edge_of_small);
  ground.ink.set_line({middle, {best.x + (best.x < middle.x ? wide : -wide) / 2, best.y}});
  return box_around(best, wide, high);
}

std::string inset(const Figure& figure, const Plane& plot, const Box& place) {
  const auto& [left, top, right, bottom] = place;
  const Plane part{figure.inset->x, figure.inset->y, right - left, bottom - top};
  const auto across = [&](double at) { return std::clamp(at, 0.0, plot.width); };
  const auto down = [&](double at) { return std::clamp(at, 0.0, plot.height); };
  const Box small = enlarged(figure, plot);
  const double x0 = across(small.left);
  const double x1 = across(small.right);
  const double nearest = (left + right) / 2 < (x0 + x1) / 2 ? right : left;
  const std::string sized = fmt::format(R"( x="{:.2f}" y="{:.2f}" width="{:.2f}" height="{:.2f}")",
                                        left, top, part.width, part.height);
  std::string text = fmt::format(
      "<path class=\"lens\" d=\"M{0:.2f} {1:.2f}H{2:.2f}V{3:.2f}H{0:.2f}ZM{4:.2f} {5:.2f}L{6:.2f} "
      "{7:.2f}\"/>\n<svg{8}>\n<rect class=\"paper\" width=\"100%\" height=\"100%\"/>\n{9}",
      x0, down(small.top), x1, down(small.bottom), across((small.left + small.right) / 2),
      down((small.top + small.bottom) / 2), nearest, (top + bottom) / 2, sized,
      contents(figure, part));
  for (const FigureMarks& marks : figure.marks) {
    for (const FigurePoint& at : marks.points) {
      if (part.holds(at)) {
        const auto [x, y] = part.pixel(at);
        text += mark(marks, fmt::format(" transform=\"translate({:.2f} {:.2f})\"", x, y));
      }
    }
  }
  add(text, "</svg>\n<rect class=\"frame\"{}/>", sized);
  return text;
}

}  // namespace stillpoint::figures
