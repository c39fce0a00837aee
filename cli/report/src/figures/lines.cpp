// SPDX-License-Identifier: MIT
#include "figures/lines.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>

namespace stillpoint::report {

using figures::FigurePoint;

std::vector<double> evenly(double from, double to, int count) {
  std::vector<double> places;
  places.reserve(static_cast<std::size_t>(count));
  for (int i = 0; i < count; ++i) {
    places.push_back(std::lerp(from, to, static_cast<double>(i) / (count - 1)));
  }
  return places;
}

std::vector<FigurePoint> thinned(const std::vector<FigurePoint>& points) {
  constexpr std::size_t most_columns = 1000;  // more than a figure is wide
  if (points.size() <= 2 * most_columns) {
    return points;
  }
  std::vector<FigurePoint> kept{points.front()};
  const std::size_t step = (points.size() + most_columns - 1) / most_columns;
  for (std::size_t first = 0; first < points.size(); first += step) {
    const auto begin = points.begin() + static_cast<std::ptrdiff_t>(first);
    const auto end =
        points.begin() + static_cast<std::ptrdiff_t>(std::min(first + step, points.size()));
    const auto [least, most] = std::ranges::minmax_element(begin, end, {}, &FigurePoint::y);
    kept.push_back(*std::min(least, most));
    kept.push_back(*std::max(least, most));
  }
  kept.push_back(points.back());
  return kept;
}

}  // namespace stillpoint::report
