// SPDX-License-Identifier: MIT
#pragma once

#include "figure_ground.hpp"

#include <string>

namespace stillpoint::figures {

/// Where the least is drawn; it and the part that it enlarges are taken.
[[nodiscard]] Box place_inset(Ground& ground);
/// In pixels of the plot.
[[nodiscard]] std::string inset(const Figure& figure, const Plane& plot, const Box& place);

}  // namespace stillpoint::figures
