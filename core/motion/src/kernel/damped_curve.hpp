// SPDX-License-Identifier: MIT
#pragma once

// A motion with damping under W = k sin(lambda tau + phase) over at most one time scale, the zeros
// of its v and its largest |y|: docs/damping.md (D10) to (D14). The points are those of
// harmonic_point.hpp, with
//
//   y' = v,   v' = a,   a' = -(2 zeta a + v + r q),   w' = r q,   q' = -r w.
//
// The derivative of such a motion obeys the same equations, and so does any sum of the two.

#include "kernel/functions.hpp"
#include "kernel/harmonic_point.hpp"
#include "kernel/piece_end.hpp"
#include "kernel/positivity.hpp"

#include <algorithm>
#include <array>
#include <limits>
#include <utility>

namespace stillpoint {

template <class Real>
class DampedCurve {
 public:
  using Point = HarmonicPoint<Real>;
  using End = PieceEnd<Real, Point>;

  /// Decides nothing without a margin.
  DampedCurve(Point start, Real r, Real zeta, TippingMargin<Real>* margin = nullptr)
      : start_(std::move(start)),
        r_(std::move(r)),
        zeta_(std::move(zeta)),
        k_(magnitude(start_.w) + magnitude(start_.q)),
        time_scale_(1 / std::max(Real(1), r_)),
        margin_(margin) {}

  [[nodiscard]] const Point& start() const { return start_; }
  [[nodiscard]] const Real& r() const { return r_; }
  [[nodiscard]] const Real& time_scale() const { return time_scale_; }

  /// Of a motion like this one.
  [[nodiscard]] Point derivative(const Point& of) const {
    return {of.v, of.a, -(2 * zeta_ * of.a + of.v + r_ * of.q), r_ * of.q, -r_ * of.w};
  }

  /// For h up to the time scale.
  [[nodiscard]] Point at(const Real& h) const { return shifted(start_, h); }

  /// The first zero of v up to `to`, as a turn, or the point there. v is positive at the start or
  /// rises from 0.
  [[nodiscard]] End first_zero(const Real& to) const {
    const Point right = at(to);
    const End zero = right.v > 0 ? zero_between(start_, Real(0), right, to)
                                 : zero_in(start_, Real(0), right, to);
    return zero.event == PieceEvent::turn ? zero : End{PieceEvent::none, to, right};
  }

  /// The zero of a function that is < 0 at `low`, or starts so, and >= 0 at the end `high`, by
  /// Halley's steps kept inside. `value` gives it with two derivatives at a point.
  template <class Value>
  [[nodiscard]] End bracketed(PieceEvent event, Real low, const End& high, Value value) const {
    constexpr double half = 0.5;
    constexpr double close = 0x1p-10;
    const Real far = std::numeric_limits<Real>::max();
    End now{event, high.h, high.at};
    Real top = high.h;
    Real last = far;
    while (true) {
      const std::array<Real, 3> f = value(now.at);
      const Real newton = f[0] / f[1];
      const Real bend = newton * f[2] / (2 * f[1]);
      const Real step = magnitude(bend) < half ? Real(newton / (1 - bend)) : newton;
      const Real size = magnitude(step);
      if (size <= 2 * std::numeric_limits<Real>::epsilon() * now.h ||
          (last < close * now.h && size >= last / 4)) {
        return now;
      }
      (f[0] < 0 ? low : top) = now.h;
      const Real next = now.h - step;
      if (next > low && next < top) {
        // After a step back the state is small, and a larger one would leave it its errors.
        now.at = size < std::min(next, time_scale_) / 8 ? shifted(now.at, Real(-step)) : at(next);
        now.h = next;
        last = size;
        continue;
      }
      now.h = low + (top - low) / 2;
      last = far;
      if (!(now.h > low && now.h < top)) {
        return {event, top, at(top)};
      }
      now.at = at(now.h);
    }
  }

  /// The largest |y| up to the point `to`, a time h after the start, or `so_far` where that is
  /// larger; for a motion with y'' + 2 zeta y' + y = -w, or with a constant load beside w.
  [[nodiscard]] Real largest(const Point& to, Real h, Real so_far,
                             const Real& constant = Real(0)) const {
    so_far = std::max({so_far, magnitude(start_.y), magnitude(to.y)});
    if (bound(to, h, constant) <= so_far * (1 + 4 * std::numeric_limits<Real>::epsilon()) ||
        monotone(to, h)) {
      return so_far;
    }
    for (DampedCurve rest = rising(start_); h > resolution(h);) {
      const End end = rest.first_zero(h);
      so_far = std::max(so_far, magnitude(end.at.y));
      h -= end.h;
      rest = rising({end.at.y, Real(0), end.at.a, end.at.w, end.at.q});
    }
    return so_far;
  }

 private:
  /// (D10)
  [[nodiscard]] Point shifted(const Point& from, const Real& h) const {
    const Real angle = r_ * h;
    const Real z = magnitude(h) / time_scale_;
    const Real by_a = -2 * zeta_ * h;
    const Real by_v = -h * h;
    const Real by_q = -angle * angle;
    // The terms of v and of q, the last two.
    Real v0 = from.v;
    Real v1 = from.a * h;
    Real q0 = from.q;
    Real q1 = -from.w * angle;
    Real v = v0 + v1;
    Real q = q0 + q1;
    Real y = v0 + v1 / 2;
    Real w = q0 + q1 / 2;
    // Of the terms neglected, relative to those of order h^3: z^(n - 3) 3!/n!, or more.
    Real size{1};
    for (int n = 2; size > std::numeric_limits<Real>::epsilon() / 16; ++n) {
      const Real pair = inverse<Real>(n - 1) * inverse<Real>(n);
      Real v2 = by_a * inverse<Real>(n) * v1 + by_v * pair * (v0 + r_ * q0);
      Real q2 = by_q * pair * q0;
      v += v2;
      q += q2;
      y += v2 * inverse<Real>(n + 1);
      w += q2 * inverse<Real>(n + 1);
      v0 = std::exchange(v1, std::move(v2));
      q0 = std::exchange(q1, std::move(q2));
      size *= n > 3 ? z * inverse<Real>(n) : Real(1);
    }
    y *= h;
    w *= angle;
    const Real lost = y + w + 2 * zeta_ * (v - from.v);
    return {from.y + y, v, from.a - lost, from.w + w, q};
  }

  [[nodiscard]] Real resolution(const Real& h) const {
    return 2 * std::numeric_limits<Real>::epsilon() * std::max(h, Real(time_scale_ / 16));
  }

  /// From a point, mirrored so that v >= 0 at first.
  [[nodiscard]] DampedCurve rising(const Point& from) const {
    const Real sign = from.v != 0 ? from.v : from.a != 0 ? from.a : from.q != 0 ? -from.q : from.w;
    return {sign < 0 ? negated(from) : from, r_, zeta_};
  }

  /// (D14).
  [[nodiscard]] Real bound(const Point& to, const Real& h, const Real& constant) const {
    const Real eighth = h * h / 8;
    const Real ends = std::max(magnitude(start_.y), magnitude(to.y));
    return exponential_high(Real(zeta_ * h)) * (ends + eighth * (k_ + constant)) / (1 - eighth);
  }

  /// v keeps its sign.
  [[nodiscard]] bool monotone(const Point& to, const Real& h) const {
    return (start_.v >= 0 && to.v >= 0 && positive_between(start_, to, h)) ||
           (start_.v <= 0 && to.v <= 0 && positive_between(negated(start_), negated(to), h));
  }

  [[nodiscard]] End zero_in(const Point& left, const Real& from, const Point& right,
                            const Real& to) const {
    const End zero =
        bracketed(PieceEvent::turn, from, {PieceEvent::none, to, right}, [&](const Point& point) {
          return std::array<Real, 3>{-point.v, -point.a, -derivative(point).a};
        });
    const End earlier = zero_between(left, from, zero.at, zero.h);
    return earlier.event == PieceEvent::turn ? earlier : zero;
  }

  /// The first zero strictly between two points with v >= 0 at both; none if v > 0 there. An
  /// interval halved below the resolution of time is a graze, not a zero.
  [[nodiscard]] End zero_between(const Point& left, const Real& from, const Point& right,
                                 const Real& to) const {
    const Real length = to - from;
    const Real middle = from + length / 2;
    const bool ends = !(length > resolution(to)) || !(middle > from) || !(middle < to);
    const bool dips = margin_ != nullptr && left.a < 0 && right.a >= 0;
    const bool near = ends || length < time_scale_ / 16;
    if (ends || ((near || !dips) && positive_between(left, right, length))) {
      if (dips) {
        decide_dip(left, from, {PieceEvent::none, to, right});
      }
      return {PieceEvent::none, to, right};
    }
    const Point at_middle = at(middle);
    if (!(at_middle.v > 0)) {
      return zero_in(left, from, at_middle, middle);
    }
    const End zero = zero_between(left, from, at_middle, middle);
    return zero.event == PieceEvent::turn ? zero : zero_between(at_middle, middle, right, to);
  }

  /// How far the smallest v stays above 0.
  void decide_dip(const Point& left, const Real& from, const End& to) const {
    const End least = bracketed(PieceEvent::none, from, to, [&](const Point& point) {
      const Point next = derivative(point);
      return std::array<Real, 3>{next.v, next.a, derivative(next).a};
    });
    margin_->decide(std::max(least.at.v, Real(0)), left.v + (magnitude(left.a) + k_) * time_scale_);
  }

  /// Whether v > 0 strictly between two points a time h apart, with v >= 0 at both.
  [[nodiscard]] bool positive_between(const Point& left, const Point& right, const Real& h) const {
    // (D12)
    const Real push = -least_push(negated(left), r_, k_, h);
    const Real slower = std::min(left.v, right.v);
    if (slower > 0 && slower > h * h / 8 * exponential_high(Real(zeta_ * h)) * push) {
      return true;
    }
    return left.v > right.v ? stays_positive(reversed(right), h, Real(-zeta_))
                            : stays_positive(left, h, zeta_);
  }

  /// (D11): whether v > 0 on (0, h] after a point with v >= 0.
  [[nodiscard]] bool stays_positive(const Point& point, const Real& h, const Real& zeta) const {
    const Real push = least_push(point, r_, k_, h);
    if (point.v == 0 && point.a == 0) {
      return push >= 0 && (point.q < 0 || (point.q == 0 && point.w > 0));
    }
    const Real grown = zeta < 0 ? exponential_high(Real(zeta_ * h)) : Real(1);
    const Real lag = h * h * (std::max(zeta, Real(0)) + grown * h / 6);
    const Real sine = point.a < 0 ? Real(grown * h) : Real(h - lag);
    const Real versine = grown * h * h / 2;
    const Real by_v = point.v * (1 - versine);
    const Real by_a = point.a * sine;
    const Real by_push = push < 0 ? Real(-push * versine) : Real(0);
    const Real size = point.v + magnitude(by_a) + by_push;
    return by_v + by_a - by_push > 8 * std::numeric_limits<Real>::epsilon() * size;
  }

  Point start_;
  Real r_;
  Real zeta_;
  Real k_;  ///< |w| and |q| are never larger
  Real time_scale_;
  TippingMargin<Real>* margin_;
};

}  // namespace stillpoint
