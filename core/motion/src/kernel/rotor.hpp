// SPDX-License-Identifier: MIT
#pragma once

// Adds angles without an arctangent each: as a product of complex numbers c + i s of any length,
// and a count of quarter turns. docs/theory.md (15).
//
// The lengths do not matter, so the product is scaled by powers of two, which rounds nothing. The
// lanes of free_lanes.cpp do the same operations in the same order.

#include "kernel/functions.hpp"

#include <bit>
#include <cmath>
#include <cstdint>

namespace stillpoint {

/// The power of two that brings size > 0 into [1, 2).
template <class Real>
Real unit_scale(const Real& size) {
  using std::frexp;
  using std::ldexp;
  int exponent = 0;
  static_cast<void>(frexp(size, &exponent));
  return ldexp(Real(1), 1 - exponent);
}

/// The same from the bits of the exponent, for sizes from 2^-1022 to 2^1022.
template <>
inline double unit_scale(const double& size) {
  constexpr std::uint64_t exponent_bits = 0x7ff0000000000000;
  constexpr std::uint64_t twice_the_bias = 0x7fe0000000000000;
  const std::uint64_t exponent = std::bit_cast<std::uint64_t>(size) & exponent_bits;
  return std::bit_cast<double>(twice_the_bias - exponent);
}

template <class Real>
struct Rotor {
  Real cosine{1};  ///< >= 0, times the length
  Real sine{0};    ///< >= 0, times the length
  Real quarters{0};

  /// By the angle of c + i s in the first quadrant. The product of two such may lie in the second
  /// one; turning it back by a quarter is exact.
  void turn(const Real& c, const Real& s) {
    const Real x = cosine * c - sine * s;
    const Real y = sine * c + cosine * s;
    const bool beyond = x < 0;
    cosine = beyond ? y : x;
    sine = beyond ? Real(-x) : y;
    quarters += beyond ? 1 : 0;
    const Real scale = unit_scale(Real(cosine + sine));
    cosine *= scale;
    sine *= scale;
  }
};

/// The angle of `a` minus that of `b`, without their quarter turns: in [-pi/2, pi/2].
template <class Real>
Real angle_between(const Rotor<Real>& a, const Rotor<Real>& b) {
  const Real x = a.cosine * b.cosine + a.sine * b.sine;
  const Real y = a.sine * b.cosine - a.cosine * b.sine;
  const Real scale = unit_scale(Real(x + magnitude(y)));
  return elementary::atan2(Real(y * scale), Real(x * scale));
}

}  // namespace stillpoint
