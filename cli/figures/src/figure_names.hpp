// SPDX-License-Identifier: MIT
#pragma once

// Finds room for words within the plot.

#include "figure_layout.hpp"
#include "figure_raster.hpp"

#include <optional>
#include <set>
#include <string>
#include <vector>

namespace stillpoint::figures {

struct PlacedName {
  std::string text;
  FigurePoint centre;  ///< in pixels of the plot
  bool upright{false};
  std::vector<FigurePoint> leader{};  ///< a line to the point, from words that are not close to it
  bool on_lines{false};               ///< needs a ground to be read
};

struct NamesInPlace {
  std::vector<PlacedName> words;
  std::set<std::string> named;  ///< these are not in the legend, nor is what is too thin to see
  std::optional<Box> inset;
};

/// Notes, and the names of areas, bands, map areas and labelled curves that find room.
[[nodiscard]] NamesInPlace names_in_place(const Figure& figure, const Plane& plane);

/// Where the arrow to a mark beyond the axes is.
[[nodiscard]] FigurePoint at_frame(const Plane& plane, const FigurePoint& at);

}  // namespace stillpoint::figures
