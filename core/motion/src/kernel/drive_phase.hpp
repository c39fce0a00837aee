// SPDX-License-Identifier: MIT
#pragma once

// The phase psi = lambda tau + phase of a harmonic excitation, kept modulo 2 pi without loss:
// docs/forced.md (F6).

#include "kernel/exact_sum.hpp"
#include "kernel/functions.hpp"
#include "kernel/phase_clock.hpp"

#include <algorithm>
#include <cmath>
#include <type_traits>

namespace stillpoint {

template <class Real>
class DrivePhase {
 public:
  /// psi grows by lambda / p for each unit of p tau.
  DrivePhase(const Real& lambda, const Real& p, const Real& phase)
      : ratio_(lambda / p), time_scale_(1 / std::max(Real(1), ratio_)), psi_(phase) {
    if constexpr (std::is_floating_point_v<Real>) {
      ratio_rest_ = std::fma(-ratio_, p, lambda) / p;
    }
    reduce();
  }

  [[nodiscard]] const Real& ratio() const { return ratio_; }

  /// The time scale of motion under this excitation: 1 / max(1, ratio).
  [[nodiscard]] const Real& time_scale() const { return time_scale_; }

  /// In [-pi, pi], except for rounding.
  [[nodiscard]] Real psi() const { return psi_.value(); }

  void advance(const Real& h) {
    psi_.add_product(ratio_, h, ratio_rest_ * h);
    reduce();
  }

  void advance(const ExactSum<Real>& h) {
    advance(h.high());
    psi_.add(ratio_ * h.low());
  }

  /// pi/2 - `before` - psi, with all its digits where it is small.
  [[nodiscard]] Real short_of_crest(const Real& before) const {
    ExactSum<Real> angle(pi<Real>() / 2);
    angle.add(-psi_.high(), two_pi_rest() / 4 - psi_.low());
    angle.add(-before);
    return angle.value();
  }

  /// By a quarter of a turn or a half: then sin psi and cos psi change their signs.
  void turn_by(const Real& turns) {
    psi_.add(turns * 2 * pi<Real>(), turns * two_pi_rest());
    reduce();
  }

  [[nodiscard]] elementary::SinCosOf<Real> sin_cos() const {
    const auto [sine, cosine] = elementary::sin_cos(psi_.high());
    return {sine + psi_.low() * cosine, cosine - psi_.low() * sine};
  }

 private:
  void reduce() {
    using std::floor;
    if (!(magnitude(psi_.high()) > pi<Real>())) {
      return;
    }
    const Real turns = floor(psi_.high() / (2 * pi<Real>()) + Real(0.5));
    psi_.add_product(-turns, 2 * pi<Real>(), -turns * two_pi_rest());
  }

  /// 2 pi minus its nearest double.
  static Real two_pi_rest() {
    return std::is_floating_point_v<Real> ? Real(2.4492935982947064e-16) : Real(0);
  }

  Real ratio_;
  Real time_scale_;
  Real ratio_rest_{0};  ///< the rounding error of lambda / p
  ExactSum<Real> psi_;
};

}  // namespace stillpoint
