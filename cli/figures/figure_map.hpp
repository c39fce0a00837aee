// SPDX-License-Identifier: MIT
#pragma once

#include "figure.hpp"

#include <string>

namespace stillpoint::cli {

/// A map as a PNG with a palette, in base64.
[[nodiscard]] std::string map_base64(const FigureMap& map);

}  // namespace stillpoint::cli
