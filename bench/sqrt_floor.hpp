// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <cstddef>

namespace stillpoint::bench {

inline constexpr std::size_t roots_at_once = 1024;  ///< two arrays of them stay in the first cache
using SquareRoots = std::array<double, roots_at_once>;

/// With the instruction set that Highway has chosen; no root depends on another.
void square_roots(const SquareRoots& in, SquareRoots& out);

/// Nanoseconds for one of those: the shortest of some short runs.
[[nodiscard]] double sqrt_floor();

}  // namespace stillpoint::bench
