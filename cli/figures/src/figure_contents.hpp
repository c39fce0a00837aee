// SPDX-License-Identifier: MIT
#pragma once

// What a plot shows, in pixels of it, as SVG.

#include "figure_layout.hpp"

#include <string>

namespace stillpoint::figures {

/// Bands, areas and curves, which have no size of their own.
[[nodiscard]] std::string contents(const Figure& figure, const Plane& plot);
/// Marks, the arrows along curves, and those to marks beyond the axes.
[[nodiscard]] std::string marks(const Figure& figure, const Plane& plot);

}  // namespace stillpoint::figures
