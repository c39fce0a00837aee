// SPDX-License-Identifier: MIT
#pragma once

#include "chart_style.hpp"
#include "comparison.hpp"
#include "text.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>

namespace stillpoint::bench {

struct Point {
  double x;
  double y;
};

/// Where a panel puts errors and times.
struct Panel {
  double left;  // of the plot
  double upper;
  int least_time;  // decades of seconds
  int largest_time;

  [[nodiscard]] Point place(double error, double seconds) const {
    // What is below the spacing of doubles is luck.
    const double across = std::log10(std::clamp(error, 1e-16, 10.0));
    return {
        left + plot_width * (across - least_error) / (largest_error - least_error),
        upper + plot_height * (largest_time - std::log10(seconds)) / (largest_time - least_time)};
  }
};

/// The panel of a scene, by its place in the list.
[[nodiscard]] Panel panel(const SceneRows& scene, std::size_t index);

/// The grid and its labels, and under the plot what is across.
void axes(Text& svg, const Panel& panel, bool names_errors);

/// The settings of a method: a line through those that count right, hollow and crossed marks for
/// the others. `index` is its place in the list and says how its mark looks.
void method_line(Text& svg, const Panel& panel, const MethodRows& rows, std::size_t index);

/// The mark of a method.
void mark(Text& svg, std::size_t method, Point at, bool right);

}  // namespace stillpoint::bench
