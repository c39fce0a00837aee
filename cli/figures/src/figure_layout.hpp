// SPDX-License-Identifier: MIT
#pragma once

// Where things are in a figure, in pixels of a figure 450 wide: words of 13 pixels are then larger
// than 11 on a screen 400 wide. The headers that this one and the others of this folder bring are
// not listed again.

#include <stillpoint/figures/figure.hpp>

#include <algorithm>
#include <cmath>

namespace stillpoint::figures {

inline constexpr double figure_width = 450;
inline constexpr double legend_left = 14;
inline constexpr double text_height = 16;

/// The width of words of 13 pixels in DejaVu Sans; those of Arial are narrower.
[[nodiscard]] double text_width(std::string_view text);

/// The plane of a figure on a rectangle of pixels.
struct Plane {
  const FigureAxis& x;
  const FigureAxis& y;
  double width;
  double height;

  /// In the plot, y down. Far beyond it, only the direction counts.
  [[nodiscard]] FigurePoint pixel(const FigurePoint& at) const;
  [[nodiscard]] Points pixels(const Points& points) const;
  [[nodiscard]] bool holds(const FigurePoint& at) const;
};

struct Ticks {
  std::vector<double> values;
  std::vector<std::string> labels;
};

struct Layout {
  Ticks x;
  Ticks y;
  double left;       ///< of the plot
  double upper{28};  ///< of the plot
  double width;      ///< of the plot
  double bottom;
  double axis_words;  ///< the height below the plot

  Layout(const Figure& figure, double at_least);
};

}  // namespace stillpoint::figures
