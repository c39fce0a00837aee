// SPDX-License-Identifier: MIT
#pragma once

// The damped swing by itself, docs/damping.md section 2: with omega = sqrt(1 - zeta^2), in units
// where p = 1,
//
// | here    | means                                                                |
// |---------|----------------------------------------------------------------------|
// | sine    | s = exp(-zeta h) sin(omega h) / omega, the answer to a unit of speed |
// | cosine  | c = s' + 2 zeta s, the answer to a unit of place                     |
// | versine | 1 - c, the integral of s                                             |
// | lag     | the integral of versine                                              |
//
// zeta = 0: sin h, 1 - cos h, h - sin h. A negative zeta is the same with time reversed.

#include "kernel/functions.hpp"
#include "kernel/harmonic_point.hpp"

#include <cmath>
#include <limits>
#include <utility>

namespace stillpoint {

/// sqrt(1 - zeta^2), also next to 1.
template <class Real>
Real swing_rate(const Real& zeta) {
  using std::sqrt;
  return sqrt((1 - zeta) * (1 + zeta));
}

/// Each with all its digits for small h >= 0.
template <class Real>
struct DampedTerms {
  Real sine{0};
  Real cosine{0};
  Real versine{0};
  Real lag{0};

  DampedTerms(const Real& h, const Real& zeta) {
    if (h < 1) {
      by_series(h, zeta);
    } else {
      by_closed_form(h, zeta);
    }
  }

 private:
  void by_closed_form(const Real& h, const Real& zeta) {
    const Real omega = swing_rate(zeta);
    const auto turned = elementary::sin_cos(Real(omega * h));
    const Real left = elementary::exp(Real(-zeta * h));
    sine = left * (turned.sine / omega);
    cosine = left * turned.cosine + zeta * sine;
    versine = 1 - cosine;
    lag = (h - sine) - 2 * zeta * versine;
  }

  /// (D2): versine is h^2/2 times the sum of t_n, n >= 2; lag has t_n / (n + 1).
  void by_series(const Real& h, const Real& zeta) {
    const Real hh = h * h;
    const Real drag = 2 * zeta * h;
    Real before{1};
    Real now = -drag / 3;
    Real fall = before + now;
    Real path = before / 3 + now / 4;
    Real size = h;  // of the terms; twice h^(n - 2) / (n - 2)! is more
    for (int n = 4; size > std::numeric_limits<Real>::epsilon() / 64; ++n) {
      Real next = -(drag * now + hh * inverse<Real>(n - 1) * before) * inverse<Real>(n);
      fall += next;
      path += next * inverse<Real>(n + 1);
      size *= h * inverse<Real>(n - 2);
      before = std::exchange(now, std::move(next));
    }
    versine = hh / 2 * fall;
    cosine = 1 - versine;
    lag = h * (hh / 2) * path;
    sine = h - (lag + 2 * zeta * versine);
  }
};

}  // namespace stillpoint
