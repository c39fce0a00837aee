// SPDX-License-Identifier: MIT
#pragma once

// The best place of words in a plot.

#include "figure_ground.hpp"

#include <optional>
#include <string>
#include <vector>

namespace stillpoint::figures {

struct PlacedName {
  std::string text;
  FigurePoint centre;  ///< in pixels of the plot
  bool upright{false};
  std::vector<FigurePoint> leader{};  ///< a line to the point, from words that are not close to it
  bool on_lines{false};               ///< needs a ground to be read

  [[nodiscard]] Box box() const;
};

/// Beside, above or below one of the points: clear of every line, if that is not too far from it,
/// and on its side of a limit and of another motion.
[[nodiscard]] std::optional<PlacedName> near(const Ground& ground, const std::string& text,
                                             const std::vector<FigurePoint>& points);
/// Within the set cells, as far from their edge and from lines as may be, and at least so many
/// pixels from their edge.
[[nodiscard]] std::optional<PlacedName> within(const Ground& ground, const std::string& text,
                                               const Raster& inside, double least = 0);

}  // namespace stillpoint::figures
