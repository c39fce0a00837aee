// SPDX-License-Identifier: MIT
#pragma once

// What words in a plot keep clear of.

#include "figure_layout.hpp"
#include "figure_raster.hpp"

#include <vector>

namespace stillpoint::figures {

struct Ground {
  Ground(const Figure& drawn, const Plane& plot);

  const Figure& figure;
  Plane plane;
  Raster ink;    ///< lines, which words should not cover
  Raster taken;  ///< marks and words, which they must not; on a map its lines too
  std::vector<std::vector<FigurePoint>> others;  ///< limits, and motions to compare with

  [[nodiscard]] std::vector<FigurePoint> pixels(const std::vector<FigurePoint>& points) const;
  /// Whether words may stand there.
  [[nodiscard]] bool is_free(const Box& box) const;
};

/// Where the arrow to a mark beyond the axes is.
[[nodiscard]] FigurePoint at_frame(const Plane& plane, const FigurePoint& at);

}  // namespace stillpoint::figures
