// SPDX-License-Identifier: MIT
#pragma once

// Sums and products of doubles with what rounding takes from them, by +, - and * alone: the same
// bits on every machine, with or without a wider type or a fused multiply-add.

#include <bit>
#include <cstdint>

namespace stillpoint {

/// An unevaluated sum; |low| is at most half a unit in the last place of high.
struct DoublePair {
  double high{0};
  double low{0};
};

/// a + b exactly, by Knuth.
[[nodiscard]] inline DoublePair two_sum(double a, double b) {
  const double sum = a + b;
  const double of_b = sum - a;
  return {sum, (a - (sum - of_b)) + (b - of_b)};
}

/// The same where |a| >= |b| or a = 0, by Dekker.
[[nodiscard]] inline DoublePair ordered_sum(double a, double b) {
  const double sum = a + b;
  return {sum, b - (sum - a)};
}

/// a less its lower 27 bits, so that products of what is left are exact.
[[nodiscard]] inline double upper_bits(double a) {
  constexpr std::uint64_t upper = ~std::uint64_t{0} << 27U;
  return std::bit_cast<double>(std::bit_cast<std::uint64_t>(a) & upper);
}

/// a b to 2^-106 of itself, and exactly where it is a double, by Dekker; where the product is below
/// 1e-300, its low part loses digits.
[[nodiscard]] inline DoublePair two_product(double a, double b) {
  const double product = a * b;
  const double a1 = upper_bits(a);
  const double b1 = upper_bits(b);
  const double a2 = a - a1;
  const double b2 = b - b1;
  return {product, ((a1 * b1 - product) + a1 * b2 + a2 * b1) + a2 * b2};
}

}  // namespace stillpoint
