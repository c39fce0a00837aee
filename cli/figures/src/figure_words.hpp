// SPDX-License-Identifier: MIT
#pragma once

// The best places of words in a plot, and what they keep clear of.

#include "figure_layout.hpp"
#include "figure_raster.hpp"

#include <set>

namespace stillpoint::figures {

struct Ground {
  Ground(const Figure& drawn, const Plane& plot);

  const Figure& figure;
  Plane plane;
  Raster ink;      ///< lines, which words should not cover
  Raster taken;    ///< marks and words, which they must not; on a map its lines too
  Strokes others;  ///< limits, and motions to compare with

  /// Whether words may stand there.
  [[nodiscard]] bool is_free(const Box& box) const;
};

/// Where the arrow to a mark beyond the axes is.
[[nodiscard]] FigurePoint at_frame(const Plane& plane, const FigurePoint& at);

struct PlacedName {
  std::string text;
  FigurePoint centre;  ///< in pixels of the plot
  bool upright{false};
  Points leader{};       ///< a line to the point, from words that are not close to it
  bool on_lines{false};  ///< needs a ground to be read

  [[nodiscard]] Box box() const;
};

/// Beside, above or below one of the points: clear of every line, if that is not too far from it,
/// and on its side of a limit and of another motion.
[[nodiscard]] std::optional<PlacedName> near(const Ground& ground, const std::string& text,
                                             const Points& points);
/// Within the set cells, as far from their edge and from lines as may be, and at least so many
/// pixels from their edge.
[[nodiscard]] std::optional<PlacedName> within(const Ground& ground, const std::string& text,
                                               const Raster& inside, double least = 0);
/// Where the least is drawn; it and the part that it enlarges are taken.
[[nodiscard]] Box place_inset(Ground& ground);

struct NamesInPlace {
  std::vector<PlacedName> words;
  std::set<std::string> named;  ///< these are not in the legend, nor is what is too thin to see
  std::optional<Box> inset;
};

/// Notes, and the names of areas, bands, map areas and labelled curves that find room.
[[nodiscard]] NamesInPlace names_in_place(const Figure& figure, const Plane& plane);

}  // namespace stillpoint::figures
