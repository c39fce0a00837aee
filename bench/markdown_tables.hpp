// SPDX-License-Identifier: MIT
#pragma once

#include "comparison.hpp"
#include "text.hpp"

namespace stillpoint::bench {

/// The best rival for each scene and bound.
void ratios(Text& text, const Comparison& comparison);

/// The time of each peer at 1e-8, and how many of its settings have a wrong count.
void each_peer(Text& text, const Comparison& comparison);

/// Scene S6.
void many_dampers(Text& text, const Comparison& comparison);

/// The free kernel in each mode, and the square root.
void free_kernel(Text& text, const Comparison& comparison);

}  // namespace stillpoint::bench
