// SPDX-License-Identifier: MIT
#include "figure_words.hpp"

namespace stillpoint::figures {

namespace {

FigurePoint nearest_of(const Box& box, const FigurePoint& at) {
  return {std::clamp(at.x, box.left, box.right), std::clamp(at.y, box.top, box.bottom)};
}

FigurePoint farthest_of(const Box& box, const FigurePoint& at) {
  return {at.x < (box.left + box.right) / 2 ? box.right : box.left,
          at.y < (box.top + box.bottom) / 2 ? box.bottom : box.top};
}

/// Whether the line through a and b separates two points.
bool is_between(const FigurePoint& a, const FigurePoint& b, const FigurePoint& one,
                const FigurePoint& other) {
  const auto side = [&](const FigurePoint& at) {
    return (b.x - a.x) * (at.y - a.y) - (b.y - a.y) * (at.x - a.x);
  };
  return side(one) * side(other) < 0;
}

/// Whether words would lie on or beyond a limit or another motion, which they would name or call
/// exceeded, however close to it the point is.
bool misleads(const Ground& ground, const FigurePoint& point, const Box& words) {
  const FigurePoint end = farthest_of(words, point);
  return std::ranges::any_of(ground.others, [&](const Points& line) {
    return std::ranges::adjacent_find(line, [&](const FigurePoint& a, const FigurePoint& b) {
             return is_between(a, b, point, end) && is_between(point, end, a, b);
           }) != line.end();
  });
}

/// From words to the nearest of their points, unless they are close to it.
Points leader(const Points& points, const Box& words) {
  constexpr double close = 18;  // pixels: a mark lies between
  const auto apart = [&](const FigurePoint& point) {
    const FigurePoint nearest = nearest_of(words, point);
    return std::hypot(nearest.x - point.x, nearest.y - point.y);
  };
  const FigurePoint point = *std::ranges::min_element(points, {}, apart);
  return apart(point) > close ? std::vector{nearest_of(words, point), point} : Points{};
}

}  // namespace

Box PlacedName::box() const {
  const double width = text_width(text);
  return upright ? box_around(centre, text_height, width) : box_around(centre, width, text_height);
}

std::optional<PlacedName> near(const Ground& ground, const std::string& text,
                               const Points& points) {
  constexpr double clear = 2;        // pixels above and below
  constexpr double farther = 0.15;   // of a cell covered, a pixel
  constexpr double covering = 12;    // cells: 80 pixels away rather than on a line
  constexpr double misleading = 60;  // cells: rather on a line
  const double width = text_width(text);
  std::optional<PlacedName> best;
  double least = HUGE_VAL;
  for (double gap = 7; gap < 70; gap += 4) {
    for (const FigurePoint& point : points) {
      for (const double right : {1.0, 0.0, -1.0, 0.5, -0.5, 0.25, -0.25}) {
        for (const double down : {-1, 1, 0}) {
          const FigurePoint centre{point.x + right * (width / 2 + gap),
                                   point.y + down * (text_height / 2 + gap)};
          const Box box = box_around(centre, width, text_height);
          if ((std::abs(right) != 1 && down == 0) || !ground.is_free(box)) {
            continue;
          }
          const int covered = ground.ink.set_in(box_around(centre, width, text_height + 2 * clear));
          double cost = covered + (covered > 0 ? covering : 0) + farther * gap;
          cost += cost < least && misleads(ground, point, box) ? misleading : 0;
          if (cost < least) {
            least = cost;
            best = {text, centre, false, leader(points, box), ground.ink.set_in(box) > 0};
          }
        }
      }
    }
  }
  return best;
}

}  // namespace stillpoint::figures
