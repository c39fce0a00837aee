// SPDX-License-Identifier: MIT
#pragma once

namespace stillpoint::bench {

/// Nanoseconds for one square root among many, with the instruction set that Highway has chosen:
/// the shortest of some short runs.
[[nodiscard]] double sqrt_floor();

}  // namespace stillpoint::bench
