// SPDX-License-Identifier: MIT
#pragma once

#include "figure_layout.hpp"

#include <string>
#include <vector>

namespace stillpoint::figures {

/// Path data of straight lines, or of a curve, through points of the plane.
[[nodiscard]] std::string path(const Plane& plane, const std::vector<FigurePoint>& points,
                               bool smooth = false);

/// A place on a line, and the direction of the line there in degrees, clockwise from the right.
struct Heading {
  FigurePoint at;  ///< in pixels
  double angle{0};
};

/// A few along the stroke, evenly spaced.
[[nodiscard]] std::vector<Heading> headings(const Plane& plane,
                                            const std::vector<FigurePoint>& stroke);

}  // namespace stillpoint::figures
