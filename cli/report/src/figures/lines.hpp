// SPDX-License-Identifier: MIT
#pragma once

// Lines of figures: values over a range, and what is left of more points than can be seen.

#include <stillpoint/figures/figure.hpp>

#include <optional>
#include <vector>

namespace stillpoint::report {

/// A line through value(x), which is empty where it ends.
template <class Value>
std::vector<std::vector<figures::FigurePoint>> line_over(const std::vector<double>& places,
                                                         const Value& value) {
  std::vector<std::vector<figures::FigurePoint>> strokes{{}};
  for (const double x : places) {
    if (const std::optional<double> y = value(x)) {
      strokes.back().push_back({x, *y});
    } else if (!strokes.back().empty()) {
      strokes.emplace_back();
    }
  }
  std::erase_if(strokes, [](const auto& stroke) { return stroke.empty(); });
  return strokes;
}

/// Evenly spaced.
[[nodiscard]] std::vector<double> evenly(double from, double to, int count);

/// The least and the largest of each column and both ends, if there are more points than columns.
[[nodiscard]] std::vector<figures::FigurePoint> thinned(
    const std::vector<figures::FigurePoint>& points);

}  // namespace stillpoint::report
