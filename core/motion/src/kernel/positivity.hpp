// SPDX-License-Identifier: MIT
#pragma once

// Sufficient conditions for v > 0 between two points of a harmonic piece, from the states at both
// ends alone: docs/forced.md section 4. They use no trigonometry.

#include "kernel/harmonic_point.hpp"
#include "kernel/phase_clock.hpp"

#include <algorithm>
#include <limits>

namespace stillpoint {

/// (F14): sin h and cos h on [0, pi] from below, sin h and 1 - cos h from above.
template <class Real>
struct SineBounds {
  Real sine_low;
  Real sine_high;
  Real cosine_low;
  Real versine_high;

  explicit SineBounds(const Real& h) {
    const Real z = h * h;
    const Real cubic = z * (Real(1) / 120) - Real(1) / 6;
    sine_low = h * (1 + z * (cubic - z * z * (Real(1) / 5040)));
    sine_high = h * (1 + z * (cubic - z * z * (Real(1) / 5040) + z * z * z * (Real(1) / 362880)));
    versine_high = z * (Real(1) / 2 - z * (Real(1) / 24 - z * (Real(1) / 720)));
    cosine_low = 1 - versine_high;
  }
};

/// exp(x), or more, for 0 <= x <= 1.
template <class Real>
Real exponential_high(const Real& x) {
  return 1 + x * (1 + x);
}

/// (F13): the least of the forcing -w' over [0, h] ahead of the point, or below it.
template <class Real>
Real least_push(const HarmonicPoint<Real>& point, const Real& r, const Real& k, const Real& h) {
  using std::max;
  using std::min;
  const Real now = -r * point.q;
  const Real later = now + r * r * h * (point.w - k * r * h / 2);
  return max(Real(min(now, later)), Real(-r * k));
}

/// Whether v > 0 on (0, h] after a point with v >= 0, h <= pi, by (F12); `k` >= |w|, |q|.
template <class Real>
bool stays_positive(const HarmonicPoint<Real>& point, const Real& r, const Real& k, const Real& h) {
  const Real push = least_push(point, r, k, h);
  if (point.v == 0 && point.a == 0) {
    // After a release: the push is always forward.
    return push >= 0 && (point.q < 0 || (point.q == 0 && point.w > 0));
  }
  const SineBounds<Real> bound(h);
  const Real m = push < 0 ? Real(-push) : Real(0);
  const Real by_v = point.v * bound.cosine_low;
  const Real by_a = point.a * (point.a < 0 ? bound.sine_high : bound.sine_low);
  const Real by_push = m * bound.versine_high;
  const Real size = point.v + (point.a < 0 ? Real(-by_a) : by_a) + by_push;
  return by_v + by_a - by_push > 8 * std::numeric_limits<Real>::epsilon() * size;
}

/// The point with time reversed: v(-h) of the one is v(h) of the other.
template <class Real>
HarmonicPoint<Real> reversed(const HarmonicPoint<Real>& point) {
  return {-point.y, point.v, -point.a, -point.w, point.q};
}

/// Whether v > 0 strictly between two points of one piece, a time h apart, with v >= 0 at both.
template <class Real>
bool positive_between(const HarmonicPoint<Real>& left, const HarmonicPoint<Real>& right,
                      const Real& r, const Real& k, const Real& h) {
  if (r > 2 && h < 3) {
    // (F15): the slow part exceeds the ripple at both ends, hence between them.
    const Real c = 1 / (r * r - 1);
    const Real ripple = c * r * k;
    if (left.v - c * r * left.q > ripple && right.v - c * r * right.q > ripple) {
      return true;
    }
  }
  // From the slower end only, which is usually enough: the sine of (F12) then grows almost all the
  // way. Next to a release the proof from the other end would fail by rounding.
  if (h < Real(5) / 2 && (left.v > right.v ? stays_positive(reversed(right), r, k, h)
                                           : stays_positive(left, r, k, h))) {
    return true;
  }
  return h <= 2 * pi<Real>() && stays_positive(left, r, k, Real(h / 2)) &&
         stays_positive(reversed(right), r, k, Real(h / 2));
}

}  // namespace stillpoint
