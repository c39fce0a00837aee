// SPDX-License-Identifier: MIT
#pragma once

// The closed form of a sliding piece under W = k sin(lambda tau + phase): docs/forced.md section 2.
// Symbols as in harmonic_point.hpp.

#include "kernel/drive_phase.hpp"
#include "kernel/functions.hpp"
#include "kernel/harmonic_point.hpp"

#include <cmath>
#include <utility>

namespace stillpoint {

template <class Real>
class HarmonicFlow {
 public:
  /// `mirror` = +1 or -1 mirrors the excitation with the motion.
  HarmonicFlow(const DrivePhase<Real>& phase, HarmonicPoint<Real> start, Real mirrored_k)
      : phase_(phase), start_(std::move(start)), mirrored_k_(std::move(mirrored_k)) {}

  [[nodiscard]] const HarmonicPoint<Real>& start() const { return start_; }
  [[nodiscard]] const Real& r() const { return phase_.ratio(); }

  /// The shortest time scale of the motion.
  [[nodiscard]] const Real& time_scale() const { return phase_.time_scale(); }

  /// Fast forcing: the ripple w / (r^2 - 1) is separated. Here r^2 - 1 > 3, so no digits are
  /// lost.
  [[nodiscard]] bool fast() const { return r() > 2; }

  /// The state a time h >= 0 after the start.
  [[nodiscard]] HarmonicPoint<Real> at(const Real& h) const {
    if (h <= time_scale()) {
      return shifted(start_, r(), h);
    }
    return fast() ? split_form(h) : sinc_form(h);
  }

 private:
  /// (F3), (F4): uniformly accurate up to and at resonance.
  [[nodiscard]] HarmonicPoint<Real> sinc_form(const Real& h) const {
    const Real half_sum = (1 + r()) / 2;
    const Real half_difference = (r() - 1) / 2;
    const auto [sa, ca] = elementary::sin_cos(Real(half_sum * h));
    Real sb{0};
    Real cb{1};
    Real across = h;
    if (half_difference != 0) {
      const auto at = elementary::sin_cos(Real(half_difference * h));
      sb = at.sine;
      cb = at.cosine;
      across = sb / half_difference;
    }
    const Real along = sa / half_sum;
    const Real product = along * across / 2;
    const Real cosine = ca * cb + sa * sb;
    const Real sine = sa * cb - ca * sb;
    const HarmonicPoint<Real>& s = start_;
    const Real lever = s.a + s.w;
    const Real y =
        s.v * sine + lever * (1 - cosine) - s.w * product - s.q * ((along * cb - across * ca) / 2);
    const Real v = s.v * cosine + lever * sine - s.w * ((across * ca + along * cb) / 2) -
                   s.q * (r() * product);
    const Real turned_cosine = ca * cb - sa * sb;
    const Real turned_sine = sa * cb + ca * sb;
    const Real w = s.w * turned_cosine + s.q * turned_sine;
    return {s.y + y, v, lever - y - w, w, s.q * turned_cosine - s.w * turned_sine};
  }

  /// (F5): the ripple follows the phase itself, which is exact however many turns h spans.
  [[nodiscard]] HarmonicPoint<Real> split_form(const Real& h) const {
    DrivePhase<Real> phase = phase_;
    phase.advance(h);
    const auto [turned_sine, turned_cosine] = phase.sin_cos();
    const Real w = mirrored_k_ * turned_sine;
    const Real q = mirrored_k_ * turned_cosine;
    const Real c = 1 / (r() * r() - 1);
    const auto [half_sine, half_cosine] = elementary::sin_cos(Real(h / 2));
    const Real sine = 2 * half_sine * half_cosine;
    const Real versine = 2 * half_sine * half_sine;  // 1 - cos h, also where h is tiny
    const HarmonicPoint<Real>& s = start_;
    const Real lever = s.a + s.w + c * s.w;
    const Real slow_v = s.v - c * r() * s.q;
    const Real y = lever * versine + slow_v * sine + c * (w - s.w);
    const Real v = lever * sine - slow_v * versine + (s.v + c * r() * (q - s.q));
    return {s.y + y, v, s.a - y - (w - s.w), w, q};
  }

  DrivePhase<Real> phase_;
  HarmonicPoint<Real> start_;
  Real mirrored_k_;
};

}  // namespace stillpoint
