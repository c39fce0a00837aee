// SPDX-License-Identifier: MIT
#include "figures/drawing.hpp"

namespace stillpoint::report {

std::vector<double> evenly(double from, double to, int count) {
  std::vector<double> places;
  places.reserve(static_cast<std::size_t>(count));
  for (int i = 0; i < count; ++i) {
    places.push_back(std::lerp(from, to, static_cast<double>(i) / (count - 1)));
  }
  return places;
}

Points thinned(const Points& points) {
  constexpr std::size_t most_columns = 1000;  // more than a figure is wide
  if (points.size() <= 2 * most_columns) {
    return points;
  }
  Points kept{points.front()};
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

Points between(Points lower, const Points& upper) {
  lower.insert(lower.end(), upper.rbegin(), upper.rend());
  return lower;
}

std::vector<double> even_bounds(std::vector<double> values, std::size_t classes) {
  std::vector<double> bounds;
  for (std::size_t i = 0; !values.empty() && i <= classes; ++i) {
    const auto bound =
        values.begin() + static_cast<std::ptrdiff_t>(i * (values.size() - 1) / classes);
    std::nth_element(values.begin(), bound, values.end());
    bounds.push_back(*bound);
  }
  return bounds;
}

std::string shade_of(std::string_view colours, std::size_t index) {
  constexpr std::size_t length = 7;
  return std::string(colours.substr(length * index, length));
}

std::size_t class_of(double value, const std::vector<double>& bounds) {
  const auto inner = std::lower_bound(bounds.begin() + 1, bounds.end() - 1, value);
  return static_cast<std::size_t>(inner - bounds.begin()) - 1;
}

MapShade shade(std::string colour, const std::string& name, double low, double high,
               const std::string& unit, Hatch hatch) {
  constexpr double much = 1.1;
  const std::string values =
      (low < high ? interval_digits(low, high) : few_digits(high)) + with_blank(unit);
  return {std::move(colour), name + values,
          high < much * low ? format("≈ {:.3g}{}", (low + high) / 2, with_blank(unit)) : values,
          hatch};
}

}  // namespace stillpoint::report
