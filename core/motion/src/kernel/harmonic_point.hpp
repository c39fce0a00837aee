// SPDX-License-Identifier: MIT
#pragma once

// A state under W = k sin(lambda tau + phase) and its motion over a short time, docs/forced.md
// section 3. Mirrored so that the mass slides towards growing y; in units where p = 1.
//
// | here | means                             |
// |------|-----------------------------------|
// | y    | p x                               |
// | v    | x'                                |
// | a    | x'' / p                           |
// | w    | W / p = K sin psi                 |
// | q    | K cos psi, so that dw/dh = r q    |
// | r    | lambda / p                        |
// | h    | p times the time since the point  |

#include "kernel/functions.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>
#include <type_traits>

namespace stillpoint {

template <class Real>
struct HarmonicPoint {
  Real y;
  Real v;
  Real a;
  Real w;
  Real q;

  /// a', which is v''.
  [[nodiscard]] Real jerk(const Real& r) const { return -v - r * q; }
};

/// (F9): the point whose v is the jerk of this one, and so on; it obeys the same equation.
template <class Real>
HarmonicPoint<Real> twice_differentiated(const HarmonicPoint<Real>& point, const Real& r) {
  const Real r2 = r * r;
  return {point.a, point.jerk(r), r2 * point.w - point.a, -r2 * point.w, -r2 * point.q};
}

template <class Real>
HarmonicPoint<Real> negated(const HarmonicPoint<Real>& point) {
  return {-point.y, -point.v, -point.a, -point.w, -point.q};
}

/// 1 / n for the series; a table for what a double needs.
template <class Real>
Real inverse(int n) {
  if constexpr (std::is_same_v<Real, double>) {
    static constexpr std::array<double, 24> table{
        0,        1.0,      1.0 / 2,  1.0 / 3,  1.0 / 4,  1.0 / 5,  1.0 / 6,  1.0 / 7,
        1.0 / 8,  1.0 / 9,  1.0 / 10, 1.0 / 11, 1.0 / 12, 1.0 / 13, 1.0 / 14, 1.0 / 15,
        1.0 / 16, 1.0 / 17, 1.0 / 18, 1.0 / 19, 1.0 / 20, 1.0 / 21, 1.0 / 22, 1.0 / 23};
    return table[static_cast<std::size_t>(n)];
  } else {
    return Real(1) / n;
  }
}

/// (F10): the state a time h later by its power series, for max(1, r) |h| <= 1. Its error is a few
/// ulp of the terms themselves, so that a motion that begins like h^2 or h^3 keeps its digits.
template <class Real>
HarmonicPoint<Real> shifted(const HarmonicPoint<Real>& point, const Real& r, const Real& h) {
  using std::max;
  const Real z = max(Real(1), r) * magnitude(h);
  const Real hh = h * h;
  const Real rr = r * r * hh;
  // The terms of v and of q, n = 0, 1; then each from the one before the last.
  Real v0 = point.v;
  Real v1 = point.a * h;
  Real q0 = point.q;
  Real q1 = -point.w * (r * h);
  Real v = v0 + v1;
  Real q = q0 + q1;
  Real y = h * (v0 + v1 * inverse<Real>(2));
  Real w = q0 + q1 * inverse<Real>(2);
  // Neglected terms are below epsilon times the terms of order h^2 of the same series.
  Real size{1};
  for (int n = 2; n < 3 || size > std::numeric_limits<Real>::epsilon() / 16; n += 2) {
    const Real even = inverse<Real>(n - 1) * inverse<Real>(n);
    const Real odd = inverse<Real>(n) * inverse<Real>(n + 1);
    v0 = -(v0 + r * q0) * (hh * even);
    v1 = -(v1 + r * q1) * (hh * odd);
    q0 = -q0 * (rr * even);
    q1 = -q1 * (rr * odd);
    v += v0 + v1;
    q += q0 + q1;
    y += h * (v0 * inverse<Real>(n + 1) + v1 * inverse<Real>(n + 2));
    w += q0 * inverse<Real>(n + 1) + q1 * inverse<Real>(n + 2);
    size *= z * z * even;
  }
  const Real grown = r * h * w;
  return {point.y + y, v, point.a - y - grown, point.w + grown, q};
}

/// (F11): the length of steps whose eighth power, divided by 8!, is negligible.
template <class Real>
Real eighth_root_of_epsilon() {
  if constexpr (std::is_same_v<Real, double>) {
    return 0x1p-5;
  } else {
    using std::pow;
    static const Real value = pow(std::numeric_limits<Real>::epsilon(), Real(1) / 8);
    return value;
  }
}

/// A correction of a zero by less than this, times the step, is the last.
template <class Real>
Real last_correction() {
  if constexpr (std::is_same_v<Real, double>) {
    return 0x1p-22;
  } else {
    using std::sqrt;
    static const Real value = sqrt(std::numeric_limits<Real>::epsilon());
    return value;
  }
}

/// c[0] + c[1] d + ... + c[7] d^7.
template <class Real>
Real polynomial(const std::array<Real, 8>& c, const Real& d) {
  const Real d2 = d * d;
  const Real low = (c[0] + c[1] * d) + d2 * (c[2] + c[3] * d);
  const Real high = (c[4] + c[5] * d) + d2 * (c[6] + c[7] * d);
  return low + d2 * d2 * high;
}

/// The first eight coefficients of v and of y in the time after a point.
template <class Real>
struct HarmonicTaylor {
  std::array<Real, 8> v;
  std::array<Real, 8> y;

  HarmonicTaylor(const HarmonicPoint<Real>& point, const Real& r) {
    const HarmonicPoint<Real> second = twice_differentiated(point, r);
    const HarmonicPoint<Real> fourth = twice_differentiated(second, r);
    const HarmonicPoint<Real> sixth = twice_differentiated(fourth, r);
    v = {point.v,
         point.a,
         second.v * (Real(1) / 2),
         second.a * (Real(1) / 6),
         fourth.v * (Real(1) / 24),
         fourth.a * (Real(1) / 120),
         sixth.v * (Real(1) / 720),
         sixth.a * (Real(1) / 5040)};
    y = {point.y,
         point.v,
         point.a * (Real(1) / 2),
         second.v * (Real(1) / 6),
         second.a * (Real(1) / 24),
         fourth.v * (Real(1) / 120),
         fourth.a * (Real(1) / 720),
         sixth.v * (Real(1) / 5040)};
  }
};

/// (F10) cut after h^7: nothing is lost where |h| is below eighth_root_of_epsilon of the time scale
/// and of the time since the start of the piece, where the state may have begun like h^3.
template <class Real>
HarmonicPoint<Real> nudged(const HarmonicPoint<Real>& point, const HarmonicTaylor<Real>& taylor,
                           const Real& r, const Real& h) {
  const Real y = polynomial(taylor.y, h);
  const Real angle = r * h;
  const Real z = angle * angle;
  const Real sine = angle * (1 - z * (Real(1) / 6 - z * (Real(1) / 120 - z * (Real(1) / 5040))));
  const Real versine = z * (Real(1) / 2 - z * (Real(1) / 24 - z * (Real(1) / 720)));
  const Real grown = point.q * sine - point.w * versine;
  return {y, polynomial(taylor.v, h), point.a - (y - point.y) - grown, point.w + grown,
          point.q - (point.w * sine + point.q * versine)};
}

/// (F11): the zero of c[0] + c[1] d + ... + c[7] d^7 next to d = 0, to all digits if it is no
/// farther than `short_step`, else to some. Infinite if it does not converge. A zero of the
/// polynomial is not yet one of the motion: the caller checks. The series alone is enough where the
/// zero of the tangent is within `share` of short_step and its terms as small.
template <class Real>
Real polynomial_root(const std::array<Real, 8>& c, const Real& short_step,
                     const Real& share = Real(1) / 32) {
  using std::max;
  const Real inverse_slope = 1 / c[1];
  const Real zero = -c[0] * inverse_slope;
  // The series of the inverse function, by the terms of this one at the zero of its tangent.
  const Real scaled = zero * inverse_slope;
  const Real square = zero * zero;
  const Real t2 = scaled * c[2];
  const Real t3 = scaled * zero * c[3];
  const Real t4 = scaled * square * c[4];
  const Real t5 = scaled * (square * zero) * c[5];
  const Real t22 = t2 * t2;
  const Real third = t2 - (2 * t22 - t3);
  const Real fourth = t2 * (5 * (t3 - t22)) - t4;
  const Real fifth = (14 * t22 - 21 * t3) * t22 + 3 * t3 * t3 + (6 * t2 * t4 - t5);
  const Real closeness = max(max(magnitude(t2), magnitude(t3)), max(magnitude(t4), magnitude(t5)));
  Real d = closeness < Real(1) / 8 ? Real(zero - zero * (third - (fourth + fifth))) : zero;
  if (closeness <= share * eighth_root_of_epsilon<Real>() &&
      magnitude(zero) <= share * short_step) {
    return d;
  }
  for (int turn = 0; turn < 4; ++turn) {
    const Real d2 = d * d;
    const Real low = (c[1] + 2 * c[2] * d) + d2 * (3 * c[3] + 4 * c[4] * d);
    const Real high = (5 * c[5] + 6 * c[6] * d) + d2 * (7 * c[7]);
    const Real correction = polynomial(c, d) / (low + d2 * d2 * high);
    d -= correction;
    const Real size = magnitude(d);
    const Real tolerated = size <= short_step ? last_correction<Real>() : Real(Real(1) / 64);
    if (magnitude(correction) <= tolerated * size) {
      return d;
    }
  }
  return std::numeric_limits<Real>::infinity();
}

}  // namespace stillpoint
