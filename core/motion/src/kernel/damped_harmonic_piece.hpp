// SPDX-License-Identifier: MIT
#pragma once

// A sliding piece with damping under W = k sin(lambda tau + phase), no longer than the time scale
// of the motion, so that one power series holds for all of it: docs/damping.md section 3. For
// a ForcedRun as harmonic_piece.hpp, with the same points.

#include "kernel/damped_curve.hpp"
#include "kernel/harmonic_point.hpp"
#include "kernel/piece_end.hpp"

#include <algorithm>
#include <array>
#include <utility>

namespace stillpoint {

template <class Real>
class DampedHarmonicPiece {
 public:
  using Point = HarmonicPoint<Real>;
  using End = PieceEnd<Real, Point>;

  /// `constant` is the size of a load besides.
  DampedHarmonicPiece(const Point& start, const Real& r, const Real& zeta,
                      TippingMargin<Real>& margin, Real constant = Real(0))
      : r_(r), zeta_(zeta), constant_(std::move(constant)), motion_(start, r, zeta, &margin) {}

  [[nodiscard]] const Point& start() const { return motion_.start(); }
  [[nodiscard]] Point at(const Real& h) const { return motion_.at(h); }
  [[nodiscard]] const DampedCurve<Real>& flow() const { return motion_; }

  /// The first turn or, if asked for, arrival up to `limit`; the piece may end before without any.
  [[nodiscard]] End first_event(const Real& limit, bool want_arrival) const {
    const End end = motion_.first_zero(std::min(limit, motion_.time_scale()));
    return want_arrival && !(end.at.y < 0) ? arrival_before(end) : end;
  }

  /// Where y = 0 on a piece that ends with y >= 0, started from y < 0 and has v > 0 between.
  [[nodiscard]] End arrival_before(const End& end) const {
    return motion_.bracketed(PieceEvent::arrival, Real(0), end, [](const Point& point) {
      return std::array<Real, 3>{point.y, point.v, point.a};
    });
  }

  /// The largest |a| up to `end`, or `so_far` where that is larger.
  [[nodiscard]] Real largest_acceleration(const End& end, const Real& so_far) const {
    const auto lifted = [&](const Point& point) {
      return motion_.derivative(motion_.derivative(point));
    };
    return largest(lifted(start()), lifted(end.at), end.h, so_far);
  }

  /// The same of what the structure feels, |y + phi + 2 zeta v|: (D13).
  [[nodiscard]] Real largest_transmitted(const Real& phi, const End& end,
                                         const Real& so_far) const {
    const auto felt = [&](const Point& point) {
      const Point next = motion_.derivative(point);
      const Real c = 2 * zeta_;
      return Point{point.y + phi + c * point.v, point.v + c * next.v, point.a + c * next.a,
                   point.w + c * next.w, point.q + c * next.q};
    };
    return largest(felt(start()), felt(end.at), end.h, so_far);
  }

 private:
  [[nodiscard]] Real largest(const Point& from, const Point& to, const Real& h,
                             const Real& so_far) const {
    return DampedCurve<Real>(from, r_, zeta_).largest(to, h, so_far, constant_);
  }

  Real r_;
  Real zeta_;
  Real constant_;
  DampedCurve<Real> motion_;
};

}  // namespace stillpoint
