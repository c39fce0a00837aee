// SPDX-License-Identifier: MIT
#pragma once

// Decisions to the last bit of a double are computed in 64 bits, the long double of x86. Where long
// double has 113 bits, each operation is rounded to 64 of them, so that the results are the same.

#include <cfloat>
#include <cmath>

#if LDBL_MANT_DIG != 64
#include <array>
#include <bit>
#include <cstdint>
#include <type_traits>
#endif

namespace stillpoint::design {

#if LDBL_MANT_DIG == 64

using Wide = long double;

[[nodiscard]] inline Wide root(Wide square) {
  return std::sqrt(square);
}

#else

class Wide {
 public:
  Wide() = default;
  template <class Number>
  requires(std::is_arithmetic_v<Number> && !std::is_same_v<Number, long double>) Wide(Number value)
      : value_(value) {}  // NOLINT(google-explicit-constructor): as long double
  [[nodiscard]] explicit operator double() const { return static_cast<double>(value_); }

  friend Wide operator-(Wide a) { return Wide(Exact{-a.value_}); }
  friend Wide operator+(Wide a, Wide b) { return rounded(a.value_ + b.value_); }
  friend Wide operator-(Wide a, Wide b) { return rounded(a.value_ - b.value_); }
  friend Wide operator*(Wide a, Wide b) { return rounded(a.value_ * b.value_); }
  friend Wide operator/(Wide a, Wide b) { return rounded(a.value_ / b.value_); }
  friend Wide root(Wide square) { return rounded(std::sqrt(square.value_)); }

  friend bool operator==(Wide a, Wide b) { return a.value_ == b.value_; }
  friend bool operator<(Wide a, Wide b) { return a.value_ < b.value_; }
  friend bool operator>(Wide a, Wide b) { return a.value_ > b.value_; }
  friend bool operator<=(Wide a, Wide b) { return a.value_ <= b.value_; }
  friend bool operator>=(Wide a, Wide b) { return a.value_ >= b.value_; }

 private:
  static_assert(LDBL_MANT_DIG == 113 && std::endian::native == std::endian::little);

  struct Exact {
    long double value;
  };
  explicit Wide(Exact exact) : value_(exact.value) {}

  /// To even where it is half-way.
  static Wide rounded(long double value) {
    constexpr int lost = 113 - 64;
    auto [low, high] = std::bit_cast<std::array<std::uint64_t, 2>>(value);
    const std::uint64_t up = (std::uint64_t{1} << (lost - 1)) - 1 + ((low >> lost) & 1);
    low += up;
    high += low < up ? 1 : 0;
    low = low >> lost << lost;
    return Wide(Exact{std::bit_cast<long double>(std::array<std::uint64_t, 2>{low, high})});
  }

  long double value_{0};
};

#endif

/// The nearest double that is not below.
[[nodiscard]] inline double rounded_up(Wide value) {
  const auto nearest = static_cast<double>(value);
  return nearest < value ? std::nextafter(nearest, HUGE_VAL) : nearest;
}

/// The nearest double that is not above.
[[nodiscard]] inline double rounded_down(Wide value) {
  const auto nearest = static_cast<double>(value);
  return nearest > value ? std::nextafter(nearest, -HUGE_VAL) : nearest;
}

/// Two speeds, as V0 = beta p, so that f2 = 0 (or A = V0 p and f4 = 0): each of the three is a
/// decimal rounded by 2^-53 of itself at most, |V0 - beta p| <= 3 2^-53 V0, and their difference
/// would be that rounding alone.
[[nodiscard]] inline bool is_same(Wide v0, Wide speed) {
  const Wide difference = v0 < speed ? speed - v0 : v0 - speed;
  return difference <= 0x3p-53 * v0;
}

/// The product of two doubles, exactly unless it is below 1e-290.
struct Product {
  double high;
  double low;
};
[[nodiscard]] inline Product product(double a, double b) {
  const double high = a * b;
  return {high, std::fma(a, b, -high)};
}

/// a - b c, of which no digit is lost where they are nearly equal.
[[nodiscard]] inline Wide less_product(double a, double b, double c) {
  const auto [high, low] = product(b, c);
  return Wide(a) - high - low;
}

/// v0 p - sqrt(8) f, likewise: next to f3 only the last sum is rounded.
[[nodiscard]] inline Wide spare_of_return(double v0, double p, double f) {
  // sqrt(8) in three doubles.
  constexpr double root8 = 0x1.6a09e667f3bcdp+1;
  constexpr double rest = -0x1.bdd3413b26456p-53;
  constexpr double rest_of_rest = 0x1.57d3e3adec175p-107;
  const auto [arrives, arrives_low] = product(v0, p);
  const auto [needs, needs_low] = product(root8, f);
  const auto [more, more_low] = product(rest, f);
  return Wide(arrives) - needs + (Wide(arrives_low) - needs_low) - more -
         (Wide(more_low) + Wide(rest_of_rest) * f);
}

// One half-cycle back, (39), for decisions that are right to the last bit.

/// In speeds: phi = f/p, d = 2 Delta.
struct WideNotch {
  Wide phi;
  Wide d;

  [[nodiscard]] Wide before(Wide radius) const { return 2 * phi + root(radius * radius + d); }
  [[nodiscard]] Wide square_before(Wide radius, int steps) const {
    for (int i = 0; i < steps; ++i) {
      radius = before(radius);
    }
    return (radius - phi) * (radius + phi);
  }
  /// The least V0 whose first half-cycle has that radius or a larger one.
  [[nodiscard]] double speed(Wide radius) const {
    return rounded_up(root((radius - phi) * (radius + phi)));
  }
};

}  // namespace stillpoint::design
