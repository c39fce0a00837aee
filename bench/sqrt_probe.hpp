// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <span>

namespace stillpoint::bench {

/// to[i] = sqrt(from[i]) with the widest vectors that the machine has.
void vector_sqrt(std::span<const double> from, std::span<double> to);

/// `count` square roots, each of the previous one plus 1: the floor for a chain of half-cycles.
[[nodiscard]] double chained_sqrt(double from, std::size_t count);

}  // namespace stillpoint::bench
