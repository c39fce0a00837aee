// SPDX-License-Identifier: MIT
#pragma once

// The largest |x''| of a harmonic piece, between events as well as at them: docs/forced.md
// section 6. Its stationary points are the zeros of the jerk, which obeys the equation of v with
// the forcing differentiated twice, so that the proofs of positivity.hpp hold for it.

#include <stillpoint/core/harmonic_flow.hpp>
#include <stillpoint/core/positivity.hpp>

#include <algorithm>
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
    const Point from = lifted(flow_.start());
    const Point to = lifted(end);
    if (rough_bound(from, to, h) <= so_far) {
      return so_far;
    }
    return between(from, Real(0), to, h, so_far);
  }

 private:
  static Real magnitude(const Real& value) { return value < 0 ? Real(-value) : value; }

  /// y is the acceleration of the motion, v its jerk, and so on.
  [[nodiscard]] Point lifted(const Point& point) const {
    return twice_differentiated(point, flow_.r());
  }

  /// (F19): from each end the acceleration turns about a centre that the forcing moves; a bound for
  /// the whole piece, h <= 2 pi.
  [[nodiscard]] Real rough_bound(const Point& left, const Point& right, const Real& h) const {
    using std::max;
    using std::min;
    using std::sqrt;
    const Real& r = flow_.r();
    if (flow_.fast()) {
      const Real c = 1 / (r * r - 1);
      const Real slow = left.y - c * left.w;
      const Real slow_jerk = left.v - c * r * left.q;
      return sqrt(slow * slow + slow_jerk * slow_jerk) + c * push_;
    }
    const Real square =
        max(Real(left.y * left.y + left.v * left.v), Real(right.y * right.y + right.v * right.v));
    return sqrt(square) + push_ * min(Real(h * h / 8), Real(2));
  }

  [[nodiscard]] Real between(const Point& left, const Real& from, const Point& right,
                             const Real& to, Real so_far) const {
    using std::max;
    const Real length = to - from;
    const Real ends = max(magnitude(left.y), magnitude(right.y));
    so_far = max(so_far, ends);
    if (bound(left, right, ends, length) <= so_far || monotone(left, right, length)) {
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
    // The higher side first: it may spare the other.
    if (height(left) > height(right)) {
      so_far = between(left, from, at, cut, so_far);
      return between(at, cut, right, to, so_far);
    }
    so_far = between(at, cut, right, to, so_far);
    return between(left, from, at, cut, so_far);
  }

  /// |x''|, without the ripple where that is split off.
  [[nodiscard]] Real height(const Point& point) const {
    const Real r = flow_.r();
    return flow_.fast() ? magnitude(point.y - point.w / (r * r - 1)) : magnitude(point.y);
  }

  /// (F19), (F20): what |x''| cannot exceed between two points; a little above the truth where the
  /// interval is so short that nothing more is to be gained.
  [[nodiscard]] Real bound(const Point& left, const Point& right, const Real& ends,
                           const Real& length) const {
    using std::max;
    const Real r = flow_.r();
    const Real square = length * length;
    if (square * max(Real(1), Real(r * r)) < 1e-13) {
      return ends;
    }
    if (flow_.fast() && length < 3) {
      const Real c = 1 / (r * r - 1);
      const Real cosine = SineBounds<Real>(Real(length / 2)).cosine_low;
      return max(height(left), height(right)) / cosine + c * push_;
    }
    return square < 4 ? Real((ends + square / 8 * push_) / (1 - square / 8))
                      : std::numeric_limits<Real>::max();
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
    while (true) {
      Real next = h + step_to_turn(at, flow_.r(), Real(0));
      if (!(next > low && next < high)) {
        next = low + (high - low) / 2;
      }
      const Real d = magnitude(next - h);
      const bool small = d < flow_.time_scale() / 8;
      at = small ? shifted(at, flow_.r(), Real(next - h)) : lifted(flow_.at(next));
      h = next;
      // |x''| is stationary here: half the digits of the time give all digits of |x''|.
      if (d * d <
              std::numeric_limits<Real>::epsilon() * flow_.time_scale() * flow_.time_scale() / 4 ||
          !(h > low && h < high)) {
        at.v = Real(0);
        return h;
      }
      ((at.v > 0) == falling ? low : high) = h;
    }
  }

  HarmonicFlow<Real> flow_;
  Real push_;  ///< of w'' : k r^2
};

}  // namespace stillpoint
