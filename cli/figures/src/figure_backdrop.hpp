// SPDX-License-Identifier: MIT
#pragma once

// What is behind the curves of a figure, as SVG.

#include "figure_layout.hpp"

#include <string>

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

}  // namespace stillpoint::figures
