// SPDX-License-Identifier: MIT
#pragma once

// LinearPiece with viscous damping, docs/damping.md section 2. What is sought is a zero of a mix of
// v, a and 1. The slope of one is a sine that decays, whose zeros are known; between them the mix
// is monotone, so that no zero of it is missed.

#include "kernel/damped_terms.hpp"
#include "kernel/functions.hpp"
#include "kernel/linear_piece.hpp"
#include "kernel/phase_clock.hpp"
#include "kernel/piece_end.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>
#include <type_traits>
#include <utility>

namespace stillpoint {

template <class Real>
class DampedPiece {
 public:
  using Point = LinearPoint<Real>;
  using End = PieceEnd<Real, Point>;

  /// `load` is the size of w.
  DampedPiece(Point start, Real rate, Real load, DampedSwing<Real> swing)
      : start_(std::move(start)),
        rate_(std::move(rate)),
        load_(std::move(load)),
        swing_(std::move(swing)) {}

  [[nodiscard]] const Real& rate() const { return rate_; }

  /// (D3).
  [[nodiscard]] Point at(const Real& h) const {
    const DampedTerms<Real> t = swing_.after(h);
    const Point& s = start_;
    const Real lever = s.v + rate_;
    return {s.y + (s.v * (t.sine + 2 * zeta() * t.versine) + s.a * t.versine - rate_ * t.lag),
            s.v * t.cosine + (s.a * t.sine - rate_ * t.versine),
            s.a * (t.cosine - 2 * zeta() * t.sine) - lever * t.sine};
  }

  [[nodiscard]] End first_event(const Real& limit, bool want_arrival) const {
    // Under a constant load it reaches the turn: pieces that creep there would lose v to rounding.
    const End end = first_turn_or_end(std::min(limit, Real(2 * pi<Real>() / omega())));
    return want_arrival && !(end.at.y < 0) ? arrival_before(end) : end;
  }

  /// Where y = 0 on a piece that ends with y >= 0, started from y < 0 and has v > 0 between.
  [[nodiscard]] End arrival_before(const End& end) const {
    const auto y = [](const Point& at) { return at.y; };
    const auto v = [](const Point& at) { return at.v; };
    const auto a = [](const Point& at) { return at.a; };
    const auto [h, at] = zero_between(y, v, a, {Real(0), start_}, {end.h, end.at});
    return {PieceEvent::arrival, h, at};
  }

  /// The largest |a| up to `end`, or `so_far` where that is larger.
  [[nodiscard]] Real largest_acceleration(const End& end, const Real& so_far) const {
    const auto size = [](const Point& at) { return magnitude(at.a); };
    return largest(size, jerk(), end, so_far, Real(0));
  }

  /// The largest v, which stays above 0.
  [[nodiscard]] Real largest_speed(const End& end, const Real& so_far) const {
    using std::max;
    const auto speed = [](const Point& at) { return at.v; };
    const Mix a{Real(0), Real(1), Real(0)};
    return at_crests(speed, a, end, max(so_far, max(start_.v, end.at.v)));
  }

  /// The largest |y + phi + 2 zeta v|, which the structure feels.
  [[nodiscard]] Real largest_transmitted(const Real& phi, const End& end,
                                         const Real& so_far) const {
    const auto size = [&](const Point& at) {
      return magnitude(Real(at.y + phi + 2 * zeta() * at.v));
    };
    const Real w = -(start_.a + start_.y + phi + 2 * zeta() * start_.v);
    const Real load = std::max(magnitude(w), magnitude(Real(w + rate_ * end.h)));
    return largest(size, {Real(1), Real(2 * zeta()), Real(0)}, end, so_far, load);
  }

 private:
  [[nodiscard]] const Real& zeta() const { return swing_.zeta(); }
  [[nodiscard]] const Real& omega() const { return swing_.omega(); }

  struct Moment {
    Real h;
    Point at;
  };

  /// of_v v + of_a a + rest.
  struct Mix {
    Real of_v;
    Real of_a;
    Real rest;

    Real operator()(const Point& at) const { return of_v * at.v + of_a * at.a + rest; }
  };

  [[nodiscard]] Mix jerk() const { return {Real(-1), Real(-2 * zeta()), Real(-rate_)}; }

  /// (D4).
  [[nodiscard]] Mix slope(const Mix& mix) const {
    return {Real(-mix.of_a), Real(mix.of_v - 2 * zeta() * mix.of_a), Real(-mix.of_a * rate_)};
  }

  /// Whether a mix is a sine that decays, as each slope is.
  [[nodiscard]] bool swings(const Mix& mix) const { return mix.rest == mix.of_v * rate_; }

  /// (D5): the first zero of one after the start; the next follow each pi / omega.
  [[nodiscard]] Real first_zero_of_swing(const Mix& mix) const {
    const Real cosine = mix(start_);
    const Real sine = (slope(mix)(start_) + zeta() * cosine) / omega();
    const Real angle = elementary::atan2(Real(-cosine), sine);
    return (angle > 0 ? angle : Real(angle + pi<Real>())) / omega();
  }

  /// Whether a sine that decays may vanish in (0, h]: only where it changes its sign, if h is
  /// short.
  [[nodiscard]] bool may_vanish(const Mix& swing, const Moment& last) const {
    const Real from = swing(start_);
    const Real to = swing(last.at);
    return last.h > 1 || !((from > 0 && to > 0) || (from < 0 && to < 0));
  }

  /// The moments up to h between which the mix is monotone, in their order, until `see` wants no
  /// more.
  template <class See>
  void stretches(const Mix& mix, const Moment& last, const See& see) const {
    Moment left{Real(0), start_};
    const Mix bend = slope(mix);
    if (may_vanish(bend, last)) {
      for (Real h = first_zero_of_swing(bend); h < last.h; h += pi<Real>() / omega()) {
        const Moment right{h, at(h)};
        if (!see(left, right)) {
          return;
        }
        left = right;
      }
    }
    see(left, last);
  }

  [[nodiscard]] End first_turn_or_end(const Real& limit) const {
    const Mix v{Real(1), Real(0), Real(0)};
    if (start_.v == 0 && start_.a == 0 && rate_ > 0) {
      return {PieceEvent::turn, Real(0), start_};
    }
    const bool still = start_.v == 0 && start_.a == 0;
    if (swings(v) && !still) {
      if (const Real turn = first_zero_of_swing(v); turn <= limit) {
        return {PieceEvent::turn, turn, at(turn)};
      }
    }
    const Moment last{limit, at(limit)};
    End end{PieceEvent::none, last.h, last.at};
    if (swings(v)) {
      return end;
    }
    stretches(v, last, [&](const Moment& left, const Moment& right) {
      if (rate_ < 0 && right.h < limit && right.at.v <= left.at.v &&
          magnitude(right.at.v) <= start_.rounding(load_, rate_)) {
        end = {PieceEvent::touch, right.h, {right.at.y, std::numeric_limits<Real>::min(), Real(0)}};
        return false;
      }
      if (!(right.at.v > 0)) {
        const auto a = [](const Point& at) { return at.a; };
        const auto [h, at] = zero_between(v, a, jerk(), left, right);
        end = {PieceEvent::turn, h, at};
        return false;
      }
      return true;
    });
    return end;
  }

  /// The zero of a function that is monotone between two moments and has no one sign there: by
  /// Newton's method from the parabola at the first, halving where that leaves the bracket.
  template <class Value, class Slope, class Bend>
  [[nodiscard]] Moment zero_between(const Value& value, const Slope& slope_of, const Bend& bend_of,
                                    const Moment& left, const Moment& right) const {
    using std::max;
    using std::sqrt;
    Real low = left.h;
    Real high = right.h;
    const Real from = value(left.at);
    const Real begins = slope_of(left.at);
    const bool rises = value(right.at) > from;
    const Real square = max(Real(0), Real(begins * begins - 2 * bend_of(left.at) * from));
    Real h = low + 2 * magnitude(from) / (magnitude(begins) + sqrt(square));
    Real step = high;  // the last one
    if (!(h > low && h < high)) {
      h = low + (high - low) / 2;
    }
    while (true) {
      const Point now = at(h);
      const Real off = value(now);
      if (off == 0) {
        return {h, now};
      }
      ((off < 0) == rises ? low : high) = h;
      Real next = h - off / slope_of(now);
      if (const std::optional<Moment> found = zero_nearby(value, slope_of, {h, now}, next - h)) {
        return *found;
      }
      const Real size = magnitude(Real(next - h));
      const bool near = step < Real(0x1p-20) * h;
      if (size <= std::numeric_limits<Real>::epsilon() * h || (near && 2 * size >= step)) {
        return {h, now};  // only rounding is left
      }
      step = size;
      if (!(next > low && next < high)) {
        next = low + (high - low) / 2;
        step = high;
      }
      if (!(next > low && next < high)) {
        return {h, now};
      }
      h = next;
    }
  }

  /// The zero about d later, by Newton's method on the power series there; none if that is far.
  template <class Value, class Slope>
  [[nodiscard]] std::optional<Moment> zero_nearby(const Value& value, const Slope& slope_of,
                                                  const Moment& from, Real d) const {
    if (!std::is_same_v<Real, double> || magnitude(d) > std::min(Real(nearby), Real(from.h / 4))) {
      return std::nullopt;
    }
    const Vicinity vicinity(from.at, jerk()(from.at), zeta());
    Real last = d;
    for (int corrections = 0; corrections < 3; ++corrections) {
      const Point there = vicinity.after(d);
      const Real step = value(there) / slope_of(there);
      d -= step;
      // The next would be about step^3 / last^2.
      if (magnitude(Real(step * step * step)) <=
          std::numeric_limits<Real>::epsilon() * from.h * last * last) {
        return Moment{from.h + d, vicinity.after(d)};
      }
      last = step;
    }
    return std::nullopt;
  }

  /// The fifth power of such a time, over 5!, is below rounding.
  static constexpr double nearby = 0x1p-10;

  /// What is near a point in time.
  class Vicinity {
   public:
    Vicinity(const Point& at, Real jerk, const Real& zeta)
        : at_(at),
          d2_(std::move(jerk)),
          d3_(-(at.a + 2 * zeta * d2_)),
          d4_(-(d2_ + 2 * zeta * d3_)),
          d5_(-(d3_ + 2 * zeta * d4_)) {}

    [[nodiscard]] Point after(const Real& d) const {
      const auto& [y, v, a] = at_;
      const Real half = d / 2;
      const Real third = d * inverse<Real>(3);
      const Real fourth = d / 4;
      const Real fifth = d * inverse<Real>(5);
      return {y + d * (v + half * (a + third * (d2_ + fourth * (d3_ + fifth * d4_)))),
              v + d * (a + half * (d2_ + third * (d3_ + fourth * (d4_ + fifth * d5_)))),
              a + d * (d2_ + half * (d3_ + third * (d4_ + fourth * d5_)))};
    }

   private:
    const Point& at_;
    Real d2_;
    Real d3_;
    Real d4_;
    Real d5_;
  };

  /// The largest `size`, which grows or falls where the mix has one sign. It is at most that of a,
  /// which only swings, and of the load.
  template <class Size>
  [[nodiscard]] Real largest(const Size& size, const Mix& mix, const End& end, const Real& so_far,
                             const Real& load) const {
    using std::max;
    const Real ends = max(size(start_), size(end.at));
    Real most = max(so_far, ends);
    const Real sine = (jerk()(start_) + zeta() * start_.a) / omega();
    const Real square = start_.a * start_.a + sine * sine;
    const Real room = most - load;
    const Real swell = (1 + 2 * zeta()) * (end.h * end.h) / 8;
    const Real below = most - ends;
    if ((room > 0 && square <= room * room) || swell * swell * square < below * below) {
      return most;
    }
    if (swings(mix)) {
      return at_crests(size, mix, end, most);
    }
    const Mix bend = slope(mix);
    stretches(mix, {end.h, end.at}, [&](const Moment& left, const Moment& right) {
      if ((mix(left.at) < 0) != (mix(right.at) < 0)) {
        const Moment crest = zero_between(mix, bend, slope(bend), left, right);
        most = max(most, size(crest.at));
      }
      return true;
    });
    return most;
  }

  /// The largest `size` at the zeros of a sine that decays, and `most`.
  template <class Size>
  [[nodiscard]] Real at_crests(const Size& size, const Mix& swing, const End& end,
                               Real most) const {
    if (may_vanish(swing, {end.h, end.at})) {
      for (Real h = first_zero_of_swing(swing); h < end.h; h += pi<Real>() / omega()) {
        most = std::max(most, size(at(h)));
      }
    }
    return most;
  }

  Point start_;
  Real rate_;
  Real load_;
  DampedSwing<Real> swing_;
};

}  // namespace stillpoint
