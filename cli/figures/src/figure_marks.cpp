// SPDX-License-Identifier: MIT
#include "figure_looks.hpp"
#include "figure_parts.hpp"
#include "figure_words.hpp"

#include <numbers>

namespace stillpoint::figures {

namespace {

bool are_close(const FigurePoint& one, const FigurePoint& other, double apart) {
  return std::hypot(one.x - other.x, one.y - other.y) < apart;
}

/// Whether an arrow would lie on a mark.
bool is_marked(const Figure& figure, const Plane& plot, const FigurePoint& pixel) {
  constexpr double apart = 11;
  return std::ranges::any_of(figure.marks, [&](const FigureMarks& marks) {
    return std::ranges::any_of(marks.points, [&](const FigurePoint& point) {
      return are_close(plot.pixel(point), pixel, apart);
    });
  });
}

/// A few along each stroke, evenly spaced, off marks and each other.
void add_arrows(std::string& text, const Figure& figure, const Plane& plot,
                const FigureCurve& curve) {
  constexpr double along = 160;
  constexpr double shortest = 60;
  constexpr double apart = 24;
  Points arrows;
  for (const auto& stroke : curve.strokes) {
    const Points line = plot.pixels(stroke);
    std::vector<double> reached{0};
    for (std::size_t i = 1; i < line.size(); ++i) {
      reached.push_back(reached.back() +
                        std::hypot(line[i].x - line[i - 1].x, line[i].y - line[i - 1].y));
    }
    const double length = reached.back();
    const double spacing = length / std::ceil(length / along);
    double next = length < shortest ? HUGE_VAL : spacing / 2;
    for (std::size_t i = 1; i < line.size(); ++i) {
      if (reached[i] < next) {
        continue;
      }
      next += spacing;
      const FigurePoint& at = line[i];
      if (!is_marked(figure, plot, at) && std::ranges::none_of(arrows, [&](const auto& other) {
            return are_close(other, at, apart);
          })) {
        arrows.push_back(at);
        add(text,
            "{}><path class=\"disc arrow {}\" transform=\"rotate({:.1f})\" "
            "d=\"M-5-4.5L5 0L-5 4.5Z\"/></g>\n",
            pin(at), of(ink_words, curve.ink),
            std::atan2(at.y - line[i - 1].y, at.x - line[i - 1].x) * 180 / std::numbers::pi);
      }
    }
  }
}

/// Degrees from the right, clockwise, along the nearest way out of the plot.
double outward(const Plane& plot, const FigurePoint& at) {
  const int right = at.x > plot.x.most ? 1 : at.x < plot.x.least ? -1 : 0;
  const int down = at.y > plot.y.most ? -1 : at.y < plot.y.least ? 1 : 0;
  return right == 0 ? 90.0 * down : right > 0 ? 45.0 * down : 180 - 45.0 * down;
}

}  // namespace

std::string marks(const Figure& figure, const Plane& plot) {
  std::string text;
  for (const FigureCurve& curve : figure.curves) {
    if (curve.directed) {
      add_arrows(text, figure, plot, curve);
    }
  }
  for (const FigureMarks& marks : figure.marks) {
    const std::string name = escaped(marks.name);
    for (const FigurePoint& at : marks.points) {
      text += pin(at_frame(plot, at));
      if (plot.holds(at)) {
        add(text, " data-name=\"{}\" data-at=\"{} {}\">{}</g>\n", name, at.x, at.y, mark(marks));
      } else {
        add(text,
            " data-far=\"{}\"><path class=\"disc {}\" transform=\"rotate({:.1f})\" "
            "d=\"M-9-2H-1V-7L9 0L-1 7V2H-9Z\"/></g>\n",
            name, of(ink_words, marks.ink), outward(plot, at));
      }
    }
  }
  return text;
}

}  // namespace stillpoint::figures
