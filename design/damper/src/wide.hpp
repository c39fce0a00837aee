// SPDX-License-Identifier: MIT
#pragma once

// Decisions to the last bit of a double are computed in pairs of doubles, to 2^-100 of each result:
// the same on every machine. What is a double by itself comes out as one. Nothing here may be
// infinite but what is only compared.

#include <stillpoint/core/double_pair.hpp>

#include <array>
#include <cmath>
#include <compare>

namespace stillpoint::design {

class Wide {
 public:
  Wide() = default;
  Wide(double value)  // NOLINT(google-explicit-constructor): exact
      : pair_{value, 0} {}

  /// The nearest.
  [[nodiscard]] explicit operator double() const { return pair_.high; }
  /// What is beyond that.
  [[nodiscard]] double rest() const { return pair_.low; }

  /// To the last digit, unless it is below 1e-290; those of * end at 2^-106. The fused operation
  /// has the same bits on every machine, but is slow where it is not the processor's.
  [[nodiscard]] static Wide exact_product(double a, double b) {
    const double product = a * b;
    return {DoublePair{product, std::fma(a, b, -product)}};
  }

  /// By a power of two, exactly.
  [[nodiscard]] Wide times(double power) const {
    return {DoublePair{pair_.high * power, pair_.low * power}};
  }

  friend Wide operator-(Wide a) { return a.times(-1); }
  friend Wide operator+(Wide a, Wide b) {
    const DoublePair high = two_sum(a.pair_.high, b.pair_.high);
    const DoublePair low = two_sum(a.pair_.low, b.pair_.low);
    const DoublePair sum = ordered_sum(high.high, high.low + low.high);
    return {ordered_sum(sum.high, sum.low + low.low)};
  }
  friend Wide operator-(Wide a, Wide b) { return a + -b; }
  friend Wide operator*(Wide a, Wide b) {
    const DoublePair product = two_product(a.pair_.high, b.pair_.high);
    const double cross = a.pair_.high * b.pair_.low + a.pair_.low * b.pair_.high;
    return {ordered_sum(product.high, product.low + cross)};
  }
  friend Wide operator/(Wide a, Wide b) {
    const double inverse = 1 / b.pair_.high;  // beside the other division, which it does not delay
    const double quotient = a.pair_.high / b.pair_.high;
    const DoublePair product = two_product(quotient, b.pair_.high);
    const double left =
        ((a.pair_.high - product.high) - product.low) + (a.pair_.low - quotient * b.pair_.low);
    return {ordered_sum(quotient, left * inverse)};
  }
  friend Wide twice(Wide a) { return a.times(2); }
  friend Wide square(Wide a) { return a * a; }
  friend Wide root(Wide square) {
    const double root = std::sqrt(square.pair_.high);
    if (!(root > 0)) {
      return root;
    }
    const double inverse = 0.5 / root;
    const DoublePair product = two_product(root, root);
    const double left = ((square.pair_.high - product.high) - product.low) + square.pair_.low;
    return {ordered_sum(root, left * inverse)};
  }

  friend auto operator<=>(Wide a, Wide b) {
    return a.pair_.high == b.pair_.high ? a.pair_.low <=> b.pair_.low
                                        : a.pair_.high <=> b.pair_.high;
  }
  friend bool operator==(Wide a, Wide b) { return (a <=> b) == 0; }

 private:
  // NOLINTNEXTLINE(google-explicit-constructor): the operators above return pairs
  Wide(DoublePair pair) : pair_(pair) {}

  DoublePair pair_;
};

/// The nearest double that is not below.
[[nodiscard]] inline double rounded_up(Wide value) {
  const auto nearest = static_cast<double>(value);
  return value.rest() > 0 ? std::nextafter(nearest, HUGE_VAL) : nearest;
}

/// The nearest double that is not above.
[[nodiscard]] inline double rounded_down(Wide value) {
  const auto nearest = static_cast<double>(value);
  return value.rest() < 0 ? std::nextafter(nearest, -HUGE_VAL) : nearest;
}

/// Two speeds, as V0 = beta p, so that f2 = 0 (or A = V0 p and f4 = 0): each of the three is a
/// decimal rounded by 2^-53 of itself at most, |V0 - beta p| <= 3 2^-53 V0, and their difference
/// would be that rounding alone.
[[nodiscard]] inline bool is_same(Wide v0, Wide speed) {
  const Wide difference = v0 < speed ? speed - v0 : v0 - speed;
  return difference <= 0x3p-53 * v0;
}

/// a - b c, of which no digit is lost where they are nearly equal.
[[nodiscard]] inline Wide less_product(double a, double b, double c) {
  return a - Wide::exact_product(b, c);
}

// sqrt(8) in three doubles.
inline constexpr std::array root8{0x1.6a09e667f3bcdp+1, -0x1.bdd3413b26456p-53,
                                  0x1.57d3e3adec175p-107};

[[nodiscard]] inline Wide root_of_eight() {
  return Wide(root8[0]) + root8[1];
}

/// v0 p - sqrt(8) f, likewise.
[[nodiscard]] inline Wide spare_of_return(double v0, double p, double f) {
  return Wide::exact_product(v0, p) - Wide::exact_product(root8[0], f) -
         Wide::exact_product(root8[1], f) - root8[2] * f;
}

/// One half-cycle back, (39), in speeds: phi = f/p, d = 2 Delta.
struct WideNotch {
  Wide phi;
  Wide d;

  [[nodiscard]] Wide before(Wide radius) const { return twice(phi) + root(square(radius) + d); }
  [[nodiscard]] Wide square_before(Wide radius, int steps) const {
    for (int i = 0; i < steps; ++i) {
      radius = before(radius);
    }
    return (radius - phi) * (radius + phi);
  }
};

}  // namespace stillpoint::design
