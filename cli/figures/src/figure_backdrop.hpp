// SPDX-License-Identifier: MIT
#pragma once

// What lies behind the curves of a figure, as SVG.

#include "figure_layout.hpp"

#include <string>

namespace stillpoint::figures {

/// Grid, numbers and names.
[[nodiscard]] std::string axes(const Figure& figure, const Layout& layout);
/// The patterns that hatched areas refer to.
[[nodiscard]] std::string hatches(const Figure& figure);
/// The picture of its map. A filter finds what has more red than blue, and is hatched: the
/// difference must survive print in grey.
[[nodiscard]] std::string map(const Figure& figure, const Layout& layout);

}  // namespace stillpoint::figures
