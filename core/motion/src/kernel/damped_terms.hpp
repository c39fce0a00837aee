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

#include <array>
#include <cmath>
#include <cstddef>
#include <limits>
#include <type_traits>
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
  Real sine;
  Real cosine;
  Real versine;
  Real lag;
};

/// The swing of one zeta.
template <class Real>
class DampedSwing {
 public:
  explicit DampedSwing(const Real& zeta)
      : zeta_(zeta), omega_(swing_rate(zeta)), falls_{Real(1), Real(-2 * zeta / 3)} {
    for (std::size_t n = 2; n < falls_.size(); ++n) {
      falls_[n] = next_fall(static_cast<int>(n), falls_[n - 1], falls_[n - 2], Real(1));
    }
  }

  [[nodiscard]] const Real& zeta() const { return zeta_; }
  [[nodiscard]] const Real& omega() const { return omega_; }

  [[nodiscard]] DampedTerms<Real> after(const Real& h) const {
    if constexpr (std::is_same_v<Real, double>) {
      if (h < 0.125) {
        return by_polynomial(h);
      }
    }
    return h < 1 ? by_series(h) : by_closed_form(h);
  }

 private:
  [[nodiscard]] DampedTerms<Real> by_closed_form(const Real& h) const {
    const auto turned = elementary::sin_cos(Real(omega_ * h));
    const Real left = elementary::exp(Real(-zeta_ * h));
    const Real sine = left * (turned.sine / omega_);
    const Real cosine = left * turned.cosine + zeta_ * sine;
    const Real versine = 1 - cosine;
    return {sine, cosine, versine, (h - sine) - 2 * zeta_ * versine};
  }

  /// (D2): versine is h^2/2 times the sum of t_n, n >= 0; lag has t_n / (n + 3).
  [[nodiscard]] DampedTerms<Real> by_series(const Real& h) const {
    Real before = falls_[0];
    Real now = falls_[1] * h;
    Real fall = before + now;
    Real path = before / 3 + now / 4;
    Real size = h;  // of the terms; twice h^n / n! is more
    for (int n = 2; size > std::numeric_limits<Real>::epsilon() / 64; ++n) {
      Real next = next_fall(n, now, before, h);
      fall += next;
      path += next * inverse<Real>(n + 3);
      size *= h * inverse<Real>(n);
      before = std::exchange(now, std::move(next));
    }
    return of(h, fall, path);
  }

  /// The same with 11 terms, for h < 1/8: what is neglected is below 1e-18 of each. Even and odd
  /// ones do not wait for each other.
  [[nodiscard]] DampedTerms<Real> by_polynomial(const Real& h) const {
    const Real hh = h * h;
    std::size_t n = falls_.size() - 1;
    std::array<Real, 2> fall{falls_[n], falls_[n - 1]};
    std::array<Real, 2> path{weighted(n), weighted(n - 1)};
    while (n > 2) {
      n -= 2;
      fall = {fall[0] * hh + falls_[n], fall[1] * hh + falls_[n - 1]};
      path = {path[0] * hh + weighted(n), path[1] * hh + weighted(n - 1)};
    }
    return of(h, falls_[0] + (h * fall[1] + hh * fall[0]),
              weighted(0) + (h * path[1] + hh * path[0]));
  }

  [[nodiscard]] DampedTerms<Real> of(const Real& h, const Real& fall, const Real& path) const {
    const Real half = h * h / 2;
    const Real versine = half * fall;
    const Real lag = h * half * path;
    return {h - (lag + 2 * zeta_ * versine), 1 - versine, versine, lag};
  }

  [[nodiscard]] Real next_fall(int n, const Real& before, const Real& last, const Real& h) const {
    return -(2 * zeta_ * h * before + h * h * inverse<Real>(n + 1) * last) * inverse<Real>(n + 2);
  }

  [[nodiscard]] Real weighted(std::size_t n) const {
    return falls_[n] * inverse<Real>(static_cast<int>(n) + 3);
  }

  Real zeta_;
  Real omega_;
  std::array<Real, std::is_same_v<Real, double> ? 11 : 2> falls_;  ///< t_n / h^n
};

}  // namespace stillpoint
