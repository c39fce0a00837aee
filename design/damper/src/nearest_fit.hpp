// SPDX-License-Identifier: MIT
#pragma once

#include <bit>
#include <cmath>
#include <cstdint>
#include <optional>

namespace stillpoint::design {

/// The number nearest to `from` that `fits`, if everything from it to `to` fits as well:
/// bisection over the doubles themselves, whose bit patterns are in order, so it ends at the last
/// bit, or `close` to it, as a part of it. Empty if not even `to` fits. Both >= 0.
template <class Fits>
std::optional<double> nearest_fit(double from, double to, const Fits& fits, double close = 0) {
  if (fits(from)) {
    return from;
  }
  if (!fits(to)) {
    return std::nullopt;
  }
  auto wrong = std::bit_cast<std::int64_t>(from);
  auto right = std::bit_cast<std::int64_t>(to);
  const auto apart = [&] {
    return std::abs(std::bit_cast<double>(wrong) - std::bit_cast<double>(right));
  };
  while ((wrong - right > 1 || right - wrong > 1) &&
         apart() > close * std::bit_cast<double>(right)) {
    const std::int64_t middle = wrong + (right - wrong) / 2;
    (fits(std::bit_cast<double>(middle)) ? right : wrong) = middle;
  }
  return std::bit_cast<double>(right);
}

}  // namespace stillpoint::design
