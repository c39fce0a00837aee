// SPDX-License-Identifier: MIT
#pragma once

// Whether friction holds the mass at rest: |W + p^2 x| <= f, docs/forced.md section 1, rule 2. In
// the units of forced_run.hpp that is |w + u| <= phi, but w = W / p and phi = f / p are rounded
// separately, so for a load that equals f exactly, such as a plateau of a record, rounding would
// decide whether it is held. If they are too close to tell, W, p u and f themselves decide.

#include "kernel/exact_sum.hpp"
#include "kernel/functions.hpp"

#include <cmath>
#include <limits>
#include <utility>

namespace stillpoint {

/// A load: w = W / p, and W itself, exact where it can be.
template <class Real>
struct Load {
  Real w{0};
  ExactSum<Real> full;
};

template <class Real>
class Hold {
 public:
  static constexpr bool symmetric = true;

  /// At the place u = p x, by friction and in a notch that holds `h` besides, `spare` = h / p:
  /// docs/notches.md, rule 1.
  Hold(Real p, Real f, Real phi, Real u, Real h = Real(0), Real spare = Real(0))
      : p_(std::move(p)),
        f_(std::move(f)),
        friction_(std::move(phi)),
        phi_(friction_ + spare),
        u_(std::move(u)),
        h_(std::move(h)),
        spare_(std::move(spare)) {}

  [[nodiscard]] const Real& u() const { return u_; }
  /// The load that is held in the direction `sign`.
  [[nodiscard]] const Real& phi(int /*sign*/) const { return phi_; }

  /// What a load exceeds phi by. In this order, or a spare that is small beside the friction would
  /// be rounded, and with it the small difference that decides when the mass sets off.
  [[nodiscard]] Real beyond(const Real& load, int /*sign*/) const {
    return load - friction_ - spare_;
  }

  /// The direction of the load with the spring, +1 or -1.
  [[nodiscard]] int sign(const Load<Real>& load) const { return load.w + u_ > 0 ? 1 : -1; }

  /// The scale of a load: its error is a few epsilon of this.
  [[nodiscard]] Real size(const Real& w) const { return magnitude(u_) + magnitude(w) + phi_; }

  /// Whether a difference of w + u and phi may be rounding alone.
  [[nodiscard]] static bool may_tie(const Real& difference, const Real& size) {
    return magnitude(difference) <= 4 * std::numeric_limits<Real>::epsilon() * size;
  }

  /// Up to this, |w + u| is certainly held: it is not a tie, since |w| <= |w + u| + |u| there.
  [[nodiscard]] Real held_for_certain() const {
    return phi_ - 16 * std::numeric_limits<Real>::epsilon() * (phi_ + magnitude(u_));
  }

  /// By how much load and spring exceed phi in the direction `sign`; held where <= 0.
  [[nodiscard]] Real excess(const Load<Real>& load, int sign) const {
    return sharpened(Real(Real(sign) * (load.w + u_) - phi_), load, sign);
  }

  /// `rounded` is that excess, as the caller computed it from w and phi.
  [[nodiscard]] Real sharpened(const Real& rounded, const Load<Real>& load, int sign) const {
    return may_tie(rounded, size(load.w)) ? exact_excess(load, sign) : rounded;
  }

  /// The direction in which the load drives the mass: 0 where it is held.
  [[nodiscard]] int drives(const Load<Real>& load) const {
    const int toward = sign(load);
    return excess(load, toward) > 0 ? -toward : 0;
  }

 private:
  /// A separate function, since it is hardly ever called.
  [[gnu::noinline]] [[nodiscard]] Real exact_excess(const Load<Real>& load, int sign) const {
    ExactSum<Real> exact{Real(-f_)};
    exact.add(Real(-h_));
    exact.add(Real(Real(sign) * load.full.high()), Real(Real(sign) * load.full.low()));
    exact.add_product(Real(Real(sign) * p_), u_);
    return exact.value() / p_;
  }

  Real p_;
  Real f_;
  Real friction_;  ///< f / p
  Real phi_;
  Real u_;
  Real h_;
  Real spare_;
};

}  // namespace stillpoint
