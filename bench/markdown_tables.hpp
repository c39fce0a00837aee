// SPDX-License-Identifier: MIT
#pragma once

#include "comparison.hpp"
#include "text.hpp"

namespace stillpoint::bench {

/// For each scene and bound the best of the rivals.
void ratios(Text& text, const Comparison& comparison);

/// What each of the peers costs at 1e-8, and how many of its settings count wrong.
void each_peer(Text& text, const Comparison& comparison);

/// The free kernel in its modes beside the square root.
void free_kernel(Text& text, const Comparison& comparison);

/// A scene, its reference and every setting of every method.
void all_rows(Text& text, const SceneRows& scene);

}  // namespace stillpoint::bench
