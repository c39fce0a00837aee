// SPDX-License-Identifier: MIT
#pragma once

#include <bit>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <vector>

namespace stillpoint {

/// The first value that is larger in magnitude or not a number; limit >= 0. It first tests whether
/// there is any, since a record is checked before each run: magnitudes are ordered like their bits,
/// with NaN last, and differences of integers compile to vector instructions.
[[nodiscard]] inline std::optional<std::size_t> first_beyond(const std::vector<double>& values,
                                                             double limit) {
  constexpr std::uint64_t sign = std::uint64_t{1} << 63;
  const auto limit_bits = std::bit_cast<std::uint64_t>(limit);
  std::uint64_t differences = 0;
  for (const double value : values) {
    differences |= limit_bits - (std::bit_cast<std::uint64_t>(value) & ~sign);
  }
  if ((differences & sign) == 0) {
    return std::nullopt;
  }
  std::size_t i = 0;
  while (std::abs(values[i]) <= limit) {
    ++i;
  }
  return i;
}

}  // namespace stillpoint
