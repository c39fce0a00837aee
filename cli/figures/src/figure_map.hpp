// SPDX-License-Identifier: MIT
#pragma once

#include <stillpoint/figures/figure.hpp>

#include <string>

namespace stillpoint::figures {

/// A map as a PNG with a palette, in base64.
[[nodiscard]] std::string map_base64(const FigureMap& map);

}  // namespace stillpoint::figures
