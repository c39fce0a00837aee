// SPDX-License-Identifier: MIT
#pragma once

// What all figures are drawn with: their parts, lines over a range and shades, and what is said of
// them in words, digits and units. The headers that this one brings are not listed again in this
// folder.

#include "format.hpp"
#include "units.hpp"

#include <stillpoint/figures/figure.hpp>
#include <stillpoint/report/digits.hpp>

#include <algorithm>
#include <cmath>

namespace stillpoint::report {

using figures::AreaLook;
using figures::axis_around;
using figures::Dash;
using figures::Figure;
using figures::FigureArea;
using figures::FigureAxis;
using figures::FigureCurve;
using figures::FigureMap;
using figures::FigurePoint;
using figures::Fill;
using figures::Hatch;
using figures::Ink;
using figures::joined;
using figures::MapShade;
using figures::Points;
using figures::rectangle;
using figures::Scale;
using figures::Shape;
using figures::Strokes;

/// A line through value(x) times a unit, which is empty where it ends.
template <class Value>
Strokes line_over(const std::vector<double>& places, double unit, const Value& value) {
  Strokes strokes{{}};
  for (const double x : places) {
    if (const std::optional<double> y = value(x)) {
      strokes.back().push_back({x, *y * unit});
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
[[nodiscard]] Points thinned(const Points& points);

/// The outline of what lies between two lines.
[[nodiscard]] Points between(Points lower, const Points& upper);

/// The bounds of classes that hold equally many of the values; empty without any.
[[nodiscard]] std::vector<double> even_bounds(std::vector<double> values, std::size_t classes);
/// "#rrggbb", of several one behind the other.
[[nodiscard]] std::string shade_of(std::string_view colours, std::size_t index);
/// Of a value between the first bound and the last; a bound belongs to the class below it.
[[nodiscard]] std::size_t class_of(double value, const std::vector<double>& bounds);
/// A shade of cells with values from `low` to `high`, written among them: "0.21 to 0.233 g", or
/// "≈ 0.222 g" of those that hardly differ.
[[nodiscard]] MapShade shade(std::string colour, const std::string& name, double low, double high,
                             const std::string& unit, Hatch hatch = Hatch::none);

}  // namespace stillpoint::report
