// SPDX-License-Identifier: MIT
#pragma once

// The largest |x''| of a harmonic piece, between events as well as at them: docs/forced.md
// section 6. Its stationary points are the zeros of the jerk, which obeys the equation of v with
// the forcing differentiated twice, so that the proofs of positivity.hpp hold for it.

#include "kernel/functions.hpp"
#include "kernel/harmonic_flow.hpp"
#include "kernel/positivity.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace stillpoint {

template <class Real>
class HarmonicCrest {
 public:
  using Point = HarmonicPoint<Real>;

  HarmonicCrest(const HarmonicFlow<Real>& flow, const Real& k)
      : flow_(flow), push_(k * flow.r() * flow.r()) {}

  /// Of the piece up to `end`, a time h after its start.
  [[nodiscard]] Real largest(const Real& h, const Point& end, const Real& so_far) const {
    using std::max;
    const Point& start = flow_.start();
    const Point from = lifted(start);
    const Point to = lifted(end);
    Real most = max(so_far, max(magnitude(start.a), magnitude(end.a)));
    if (falls_from(from, h) || falls_from(reversed(to), h) || stays_below(from, to, h, most)) {
      return most;
    }
    const bool at_end = magnitude(to.v) < magnitude(from.v);
    if (const Real crest = at_end ? near_crest(reversed(to), h) : near_crest(from, h); crest > 0) {
      return max(most, crest);
    }
    return between(from, Real(0), to, h, most);
  }

 private:
  /// y is the acceleration of the motion, v its jerk, and so on.
  [[nodiscard]] Point lifted(const Point& point) const {
    return twice_differentiated(point, flow_.r());
  }

  /// (F24): |x''| falls from this point and stays below it up to h.
  [[nodiscard]] bool falls_from(const Point& point, const Real& h) const {
    const bool falls = point.y < 0 ? point.v >= 0 : point.v <= 0;
    return falls && h <= 2 && magnitude(point.y) >= 2 * magnitude(point.v) + 3 * push_;
  }

  /// The largest |x''| up to h after a point so close to its crest that a polynomial reaches it; 0
  /// if it does not, or if (F24) does not decide.
  [[nodiscard]] Real near_crest(const Point& point, const Real& h) const {
    const HarmonicTaylor<Real> taylor(point, flow_.r());
    const Real longest = std::min(h, Real(eighth_root_of_epsilon<Real>() * flow_.time_scale()));
    const Real d = polynomial_root(taylor.v, longest, Real(1));  // half of the digits are enough
    if (!(d > 0 && d <= longest && h <= 2)) {
      return Real(0);
    }
    const Real crest = magnitude(polynomial(taylor.y, d));
    const bool stationary = is_crest(polynomial(taylor.v, d), Real(taylor.v[1] * crest));
    return stationary && crest >= 3 * push_ ? crest : Real(0);
  }

  /// Whether |x''| is off its crest, by v^2/(2 |a|), by no more than rounding.
  static bool is_crest(const Real& v, const Real& a_times_y) {
    return v * v <= std::numeric_limits<Real>::epsilon() / 4 * magnitude(a_times_y);
  }

  /// (F19): from each end the acceleration turns about a centre that the forcing moves; a bound for
  /// the whole piece, h <= 2 pi.
  [[nodiscard]] bool stays_below(const Point& left, const Point& right, const Real& h,
                                 const Real& most) const {
    using std::max;
    using std::min;
    const Real& r = flow_.r();
    if (flow_.fast()) {
      const Real c = 1 / (r * r - 1);
      const Real slow = left.y - c * left.w;
      const Real slow_jerk = left.v - c * r * left.q;
      return within(slow * slow + slow_jerk * slow_jerk, most - c * push_);
    }
    const Real square =
        max(Real(left.y * left.y + left.v * left.v), Real(right.y * right.y + right.v * right.v));
    return within(square, most - push_ * min(Real(h * h / 8), Real(2)));
  }

  static bool within(const Real& square, const Real& limit) {
    return limit >= 0 && square <= limit * limit;
  }

  [[nodiscard]] Real between(const Point& left, const Real& from, const Point& right,
                             const Real& to, Real so_far) const {
    using std::max;
    const Real length = to - from;
    const Real ends = max(magnitude(left.y), magnitude(right.y));
    so_far = max(so_far, ends);
    if (adds_nothing(bound(left, right, ends, length), so_far) || monotone(left, right, length)) {
      return so_far;
    }
    const Real middle = from + length / 2;
    Real cut = middle;
    Point at{};
    const bool one_ripple = !flow_.fast() || length < 2 * flow_.time_scale();
    const bool stationary =
        one_ripple && (left.v < 0) != (right.v < 0) && left.v != 0 && right.v != 0;
    if (stationary) {
      cut = zero_of_jerk(left, from, right, to, at);
    } else {
      at = lifted(flow_.at(middle));
    }
    if (!(cut > from && cut < to)) {
      return so_far;
    }
    if (stationary && falls_from(reversed(at), Real(cut - from)) &&
        falls_from(at, Real(to - cut))) {
      return max(so_far, magnitude(at.y));
    }
    // The higher side first: it may make the other unnecessary.
    if (height(left) > height(right)) {
      so_far = between(left, from, at, cut, so_far);
      return between(at, cut, right, to, so_far);
    }
    so_far = between(at, cut, right, to, so_far);
    return between(left, from, at, cut, so_far);
  }

  /// |x''|, without the ripple where that is separated.
  [[nodiscard]] Real height(const Point& point) const {
    const Real r = flow_.r();
    return flow_.fast() ? magnitude(point.y - point.w / (r * r - 1)) : magnitude(point.y);
  }

  /// (F20), with or without the ripple: a bound of |x''| between two points.
  [[nodiscard]] Real bound(const Point& left, const Point& right, const Real& ends,
                           const Real& length) const {
    using std::max;
    using std::min;
    const Real eighth = length * length / 8;
    Real whole = std::numeric_limits<Real>::max();
    if (2 * eighth < 1) {
      whole = (ends + eighth * push_) / (1 - eighth);
    }
    if (!flow_.fast() || length >= 3) {
      return whole;
    }
    const Real c = 1 / (flow_.r() * flow_.r() - 1);
    const Real cosine = SineBounds<Real>(Real(length / 2)).cosine_low;
    return min(whole, Real(max(height(left), height(right)) / cosine + c * push_));
  }

  /// An interval with this bound cannot matter: |x''| <= (1 + 4 epsilon) so_far there.
  static bool adds_nothing(const Real& bound, const Real& so_far) {
    return bound <= so_far + 4 * std::numeric_limits<Real>::epsilon() * so_far;
  }

  /// The jerk keeps its sign, so that the largest |x''| is at an end.
  [[nodiscard]] bool monotone(const Point& left, const Point& right, const Real& length) const {
    if (left.v >= 0 && right.v >= 0) {
      return positive_between(left, right, flow_.r(), push_, length);
    }
    if (left.v <= 0 && right.v <= 0) {
      return positive_between(negated(left), negated(right), flow_.r(), push_, length);
    }
    return false;
  }

  /// A zero of the jerk between two points where it has opposite signs; its point goes to `at`.
  Real zero_of_jerk(const Point& left, const Real& from, const Point& right, const Real& to,
                    Point& at) const {
    Real low = from;
    Real high = to;
    const bool near_right = magnitude(right.v) < magnitude(left.v);
    Real h = near_right ? to : from;
    at = near_right ? right : left;
    const bool falling = left.v > 0;
    const Real longest = flow_.time_scale() / 8;
    while (true) {
      Real next = h + polynomial_root(HarmonicTaylor<Real>(at, flow_.r()).v, longest);
      if (!(next > low && next < high)) {
        next = low + (high - low) / 2;
      }
      const Real d = magnitude(next - h);
      at = d < longest ? shifted(at, flow_.r(), Real(next - h)) : lifted(flow_.at(next));
      h = next;
      // |x''| is stationary here, so half the digits of the time give all of its digits: it
      // lies v^2/(2 |a|) below its crest.
      const Real quarter = std::numeric_limits<Real>::epsilon() / 4;
      if (is_crest(at.v, Real(at.a * at.y)) ||
          d * d < quarter * flow_.time_scale() * flow_.time_scale() || !(h > low && h < high)) {
        at.v = Real(0);
        return h;
      }
      ((at.v > 0) == falling ? low : high) = h;
    }
  }

  const HarmonicFlow<Real>& flow_;
  Real push_;  ///< of w'' : k r^2
};

}  // namespace stillpoint
