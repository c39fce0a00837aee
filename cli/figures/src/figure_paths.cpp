// SPDX-License-Identifier: MIT
#include "figure_paths.hpp"

#include <fmt/compile.h>
#include <fmt/format.h>

#include <cmath>
#include <cstddef>
#include <iterator>
#include <numbers>

namespace stillpoint::figures {

namespace {

double distance(const FigurePoint& a, const FigurePoint& b) {
  return std::hypot(b.x - a.x, b.y - a.y);
}

/// Without points that cannot be distinguished from the one before.
std::vector<FigurePoint> pixels(const Plane& plane, const std::vector<FigurePoint>& points) {
  constexpr double same = 0.02;
  std::vector<FigurePoint> made;
  for (const FigurePoint& point : points) {
    const FigurePoint at = plane.pixel(point);
    if (made.empty() || distance(made.back(), at) > same) {
      made.push_back(at);
    }
  }
  return made;
}

/// The slopes of parabolas through three points each, over the length of the chords (Bessel);
/// uneven spacing does not make loops.
std::vector<FigurePoint> tangents(const std::vector<FigurePoint>& points) {
  std::vector<FigurePoint> slopes(points.size());
  const auto chord = [&points](std::size_t i) {
    const double d = distance(points[i], points[i + 1]);
    return FigurePoint{(points[i + 1].x - points[i].x) / d, (points[i + 1].y - points[i].y) / d};
  };
  for (std::size_t i = 0; i < points.size(); ++i) {
    const FigurePoint before = chord(i > 0 ? i - 1 : 0);
    const FigurePoint after = chord(i + 1 < points.size() ? i : i - 1);
    const double d0 = i > 0 ? distance(points[i - 1], points[i]) : 1;
    const double d1 = i + 1 < points.size() ? distance(points[i], points[i + 1]) : 1;
    slopes[i] = {(before.x * d1 + after.x * d0) / (d0 + d1),
                 (before.y * d1 + after.y * d0) / (d0 + d1)};
  }
  return slopes;
}

}  // namespace

std::string path(const Plane& plane, const std::vector<FigurePoint>& points, bool smooth) {
  std::string d;
  if (!smooth) {
    for (const FigurePoint& point : points) {
      const auto [x, y] = plane.pixel(point);
      fmt::format_to(std::back_inserter(d), FMT_COMPILE("{}{:.2f} {:.2f}"), d.empty() ? 'M' : 'L',
                     x, y);
    }
    return d;
  }
  const auto at = pixels(plane, points);
  if (at.size() < 2) {
    return d;
  }
  const auto slope = tangents(at);
  d = fmt::format("M{:.2f} {:.2f}", at[0].x, at[0].y);
  for (std::size_t i = 1; i < at.size(); ++i) {
    const double third = distance(at[i - 1], at[i]) / 3;
    fmt::format_to(std::back_inserter(d), "C{:.2f} {:.2f} {:.2f} {:.2f} {:.2f} {:.2f}",
                   at[i - 1].x + third * slope[i - 1].x, at[i - 1].y + third * slope[i - 1].y,
                   at[i].x - third * slope[i].x, at[i].y - third * slope[i].y, at[i].x, at[i].y);
  }
  return d;
}

std::vector<Heading> headings(const Plane& plane, const std::vector<FigurePoint>& stroke) {
  constexpr double apart = 160;
  constexpr double shortest = 60;
  const auto at = pixels(plane, stroke);
  double length = 0;
  for (std::size_t i = 1; i < at.size(); ++i) {
    length += distance(at[i - 1], at[i]);
  }
  std::vector<Heading> made;
  const double spacing = length / std::ceil(length / apart);
  double next = length < shortest ? HUGE_VAL : spacing / 2;
  double reached = 0;
  for (std::size_t i = 1; i < at.size(); ++i) {
    reached += distance(at[i - 1], at[i]);
    if (reached >= next) {
      made.push_back({at[i], std::atan2(at[i].y - at[i - 1].y, at[i].x - at[i - 1].x) * 180 /
                                 std::numbers::pi});
      next += spacing;
    }
  }
  return made;
}

}  // namespace stillpoint::figures
