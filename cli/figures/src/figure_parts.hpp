// SPDX-License-Identifier: MIT
#pragma once

// What a plot shows and what is behind it, as SVG.

#include "figure_layout.hpp"
#include "figure_raster.hpp"

namespace stillpoint::figures {

/// Grid, numbers and names.
[[nodiscard]] std::string axes(const Figure& figure, const Layout& layout);
/// The patterns that hatched areas refer to.
[[nodiscard]] std::string hatches(const Figure& figure);
/// The pattern of all hatched areas of a name.
[[nodiscard]] std::string hatch_id(const Figure& figure, const std::string& name);
inline constexpr double hatch_spacing = 7;  // pixels
inline constexpr double thinnest = 1.5;     // pixels of an area that show its colour
/// The picture of its map.
[[nodiscard]] std::string map(const Figure& figure, const Layout& layout);
/// As a PNG with a palette, in base64.
[[nodiscard]] std::string map_base64(const FigureMap& map);

/// Bands, areas and curves, which have no size of their own.
[[nodiscard]] std::string contents(const Figure& figure, const Plane& plot);
/// Marks, the arrows along curves, and those to marks beyond the axes.
[[nodiscard]] std::string marks(const Figure& figure, const Plane& plot);
/// The part that is enlarged, at its place in the plot, in pixels of it.
[[nodiscard]] std::string inset(const Figure& figure, const Plane& plot, const Box& place);

}  // namespace stillpoint::figures
