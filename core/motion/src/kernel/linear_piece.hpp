// SPDX-License-Identifier: MIT
#pragma once

// A sliding piece under an excitation that is linear in time: between two samples of a record, in a
// rectangle pulse, and after the end of any excitation. docs/forced.md section 5.
// Mirrored as in harmonic_point.hpp: y = p x, v = x', a = x''/p; `rate` = dw/dh, w = W / p.

#include "kernel/functions.hpp"
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
struct LinearPoint {
  Real y;
  Real v;
  Real a;

  /// The possible error of v on a piece from here: (F33), v only touches 0 where it is less.
  /// Friction is at most load + |y| + |a|.
  [[nodiscard]] Real rounding(const Real& load, const Real& rate) const {
    return 16 * std::numeric_limits<Real>::epsilon() *
           (magnitude(y) + load + v + magnitude(a) + magnitude(rate));
  }
};

/// sin h, 1 - cos h and h - sin h, each with all its digits for small h.
template <class Real>
struct LinearTerms {
  Real sine;
  Real versine;
  Real lag;

  LinearTerms(Real sin_h, Real one_minus_cos_h, Real h_minus_sin_h)
      : sine(std::move(sin_h)),
        versine(std::move(one_minus_cos_h)),
        lag(std::move(h_minus_sin_h)) {}

  explicit LinearTerms(const Real& h) {
    if constexpr (std::is_same_v<Real, double>) {
      if (h * h < 1.0 / 64) {
        by_series(h);
        return;
      }
    }
    const auto [half_sine, half_cosine] = elementary::sin_cos(Real(h / 2));
    sine = 2 * half_sine * half_cosine;
    versine = 2 * half_sine * half_sine;
    if (!(h < 1)) {
      lag = h - sine;
      return;
    }
    Real term = h * h * h / 6;
    lag = term;
    for (int n = 4; !(term < lag * std::numeric_limits<Real>::epsilon() / 4) && term > 0; n += 2) {
      term *= h * h / (n * (n + 1));
      lag += (n % 4 == 0) ? Real(-term) : term;
    }
  }

  /// From t = tan(h/2) up to this, which is 0.55 / 8: docs/forced.md (F31). The neglected terms are
  /// below 4e-19 of the first.
  static constexpr double largest_half_tangent = 0.06875;
  static LinearTerms of_half_tangent(const Real& t) {
    const Real z = t * t;
    const Real z2 = z * z;
    const Real low = (4.0 / 3 - z * (8.0 / 5)) + z2 * (12.0 / 7 - z * (16.0 / 9));
    const Real high = (20.0 / 11 - z * (24.0 / 13)) + z2 * (28.0 / 15 - z * (32.0 / 17));
    const Real sine = 2 * t / (1 + z);
    return {sine, t * sine, t * z * (low + z2 * z2 * high)};
  }

 private:
  /// Between the samples of a record h is small. The neglected terms are below 4e-18 of each for
  /// h < 1/8.
  void by_series(const Real& h) {
    const Real z = h * h;
    versine =
        z * (1.0 / 2 - z * (1.0 / 24 - z * (1.0 / 720 - z * (1.0 / 40320 - z * (1.0 / 3628800)))));
    lag =
        h * z *
        (1.0 / 6 - z * (1.0 / 120 - z * (1.0 / 5040 - z * (1.0 / 362880 - z * (1.0 / 39916800)))));
    sine = h - lag;
  }
};

template <class Real>
class LinearPiece {
 public:
  using Point = LinearPoint<Real>;
  using End = PieceEnd<Real, Point>;

  /// `load` is the size of w.
  LinearPiece(Point start, Real rate, Real load = Real(0))
      : start_(std::move(start)), rate_(std::move(rate)), load_(std::move(load)) {}

  [[nodiscard]] const Real& rate() const { return rate_; }

  /// (F16).
  [[nodiscard]] Point at(const Real& h) const { return after(LinearTerms<Real>(h)); }

  [[nodiscard]] End first_event(const Real& limit, bool want_arrival) const {
    const Real square = start_.a * start_.a + start_.v * (start_.v + 2 * rate_);
    const bool touch = rate_ < 0 && touches(square);
    const End end = touch ? touch_within(limit) : first_turn_or_end(square, limit);
    return want_arrival && !(end.at.y < 0) ? arrival_before(end) : end;
  }

  /// The same where the load is constant, by energy: v^2 + a^2 stays and a falls by what y grows.
  /// docs/notches.md (N1), (N2).
  [[nodiscard]] End first_event_of_constant_load(const Real& limit, bool want_arrival) const {
    using std::sqrt;
    const Point& s = start_;
    const Real rise = -s.y;
    const Real square = s.v * s.v + rise * (2 * s.a - rise);
    End end{};
    if (want_arrival && square >= 0) {
      const Real v = sqrt(square);
      end = {PieceEvent::arrival,
             2 * elementary::atan2(rise, Real(s.v + v)),
             {Real(0), v, s.a - rise}};
    } else {
      const Real radius = sqrt(s.v * s.v + s.a * s.a);
      const Real to_turn = s.a < 0 ? Real(s.v * (s.v / (radius - s.a))) : Real(radius + s.a);
      end = {
          PieceEvent::turn, 2 * elementary::atan2(to_turn, s.v), {s.y + to_turn, Real(0), -radius}};
    }
    if (end.h <= limit) {
      return end;
    }
    end = {PieceEvent::none, limit, at(limit)};
    if (want_arrival && !(end.at.y < 0)) {
      end.event = PieceEvent::arrival;  // within rounding
    }
    return end;
  }

  /// Where y = 0 on a piece that ends with y >= 0, started from y < 0 and has v > 0 between.
  [[nodiscard]] End arrival_before(const End& end) const {
    Real low{0};
    Real high = end.h;
    Real h = end.h * (start_.y / (start_.y - end.at.y));
    if (!(h > low && h < high)) {
      h = low + (high - low) / 2;
    }
    while (true) {
      const Point now = at(h);
      if (const std::optional<End> found = arrival_near(h, now)) {
        return *found;
      }
      (now.y < 0 ? low : high) = h;
      const Real z = now.y / now.v;
      const Real bend = z * now.a / (2 * now.v);
      Real next = h - z * (bend < 1 && bend > -1 ? Real(1 + bend) : Real(1));
      if (!(next > low && next < high)) {
        next = low + (high - low) / 2;
      }
      if (!(next > low && next < high)) {
        return {PieceEvent::arrival, high, at(high)};
      }
      const Real d = next - h;
      h = next;
      if ((d < 0 ? Real(-d) : d) <= 2 * std::numeric_limits<Real>::epsilon() * h) {
        return {PieceEvent::arrival, h, at(h)};
      }
    }
  }

  /// The largest |a| up to `end`, or `so_far` where that is larger: (a, a') turns rigidly.
  [[nodiscard]] Real largest_acceleration(const End& end, const Real& so_far) const {
    using std::max;
    using std::sqrt;
    const Real jerk = -(start_.v + rate_);
    const Real end_jerk = -(end.at.v + rate_);
    const Real most = max(so_far, max(magnitude(start_.a), magnitude(end.at.a)));
    const bool crest = end.h >= pi<Real>() || (jerk < 0) != (end_jerk < 0);
    return crest ? max(most, Real(sqrt(start_.a * start_.a + jerk * jerk))) : most;
  }

 private:
  /// The h in (0, 2 pi] with tan(h/2) = rise / run; run >= 0, so h <= pi where rise > 0.
  struct HalfAngle {
    Real rise;
    Real run;
  };

  /// The first turn, or the end at `limit`.
  [[nodiscard]] End first_turn_or_end(const Real& square, const Real& limit) const {
    const std::optional<HalfAngle> half = first_turn(square);
    if (half && !beyond(*half, limit)) {
      End turn = turn_after(*half, limit);
      if (turn.h > 0 && turn.h <= limit) {
        polish_turn(turn, limit);
        return turn;
      }
    }
    // No piece is long enough for the rounding of its time to matter.
    const Real h = std::min(limit, Real(2 * pi<Real>()));
    return {PieceEvent::none, h, at(h)};
  }

  /// (F33): whether the smallest v is 0 within rounding, for rate < 0. `square` is the discriminant
  /// of (F17).
  [[nodiscard]] bool touches(const Real& square) const {
    return magnitude(square) <= -2 * rate_ * start_.rounding(load_, rate_);
  }

  /// The touch, or the end at `limit`; v > 0 there, so that the mass slides on.
  [[nodiscard]] End touch_within(const Real& limit) const {
    const HalfAngle half = half_angle(start_.a, Real(start_.v + 2 * rate_));
    const Real h = beyond(half, limit) ? limit : std::min(limit, angle(half));
    End end{PieceEvent::none, h, at(h)};
    if (h < limit) {
      end.at.v = end.at.a = Real(0);
    }
    if (!(end.at.v > (end.at.a < 0 ? start_.rounding(load_, rate_) : Real(0)))) {
      end.event = PieceEvent::touch;
      end.at.v = std::max(end.at.v, std::numeric_limits<Real>::min());
    }
    return end;
  }

  /// (F17), (F34): the first h in (0, 2 pi] with v = 0, if there is one.
  [[nodiscard]] std::optional<HalfAngle> first_turn(const Real& square) const {
    using std::sqrt;
    const Point& s = start_;
    if (s.v == 0 && s.a == 0) {
      return rate_ == 0 ? std::nullopt : std::optional<HalfAngle>({Real(0), Real(1)});
    }
    if (square < 0) {
      return std::nullopt;
    }
    const Real sum = s.a < 0 ? Real(s.a - sqrt(square)) : Real(s.a + sqrt(square));
    return s.v > 0 && s.a < 0 ? HalfAngle{s.v, -sum} : half_angle(sum, Real(s.v + 2 * rate_));
  }

  /// Certainly later than `limit`, without the arctangent: tan x < 1.1 x for 0 < x < 1/2.
  static bool beyond(const HalfAngle& half, const Real& limit) {
    return limit < 1 && !(half.rise > 0 && half.rise <= Real(0.55) * limit * half.run);
  }

  /// Where y = 0 next to the state `now` at h, if the neglected orders are below rounding there.
  [[nodiscard]] std::optional<End> arrival_near(const Real& h, const Point& now) const {
    if constexpr (std::is_same_v<Real, double>) {
      constexpr double small = 0x1p-18;  // its third power is below rounding
      const Real z = now.y / now.v;
      const Real jerk = -(now.v + rate_);
      if (magnitude(z) <= small * h && magnitude(z * now.a) <= small * now.v &&
          magnitude(z * z * jerk) <= small * small * now.v) {
        const Real d = -z * (1 + z * now.a / (2 * now.v));
        return End{
            PieceEvent::arrival,
            h + d,
            {Real(0), now.v + d * (now.a + d * jerk / 2), now.a + d * (jerk - d * now.a / 2)}};
      }
    }
    return std::nullopt;
  }

  /// Not at 0, and at a place only if it comes within `limit`.
  [[nodiscard]] End turn_after(const HalfAngle& half, const Real& limit) const {
    if constexpr (std::is_same_v<Real, double>) {
      if (limit * limit < 1.0 / 64) {
        const auto terms = LinearTerms<Real>::of_half_tangent(half.rise / half.run);
        return {PieceEvent::turn, terms.sine + terms.lag, after(terms)};
      }
    }
    const Real turn = angle(half);
    return {PieceEvent::turn, turn, turn > 0 && turn <= limit ? at(turn) : Point{}};
  }

  [[nodiscard]] Point after(const LinearTerms<Real>& terms) const {
    const Point& s = start_;
    return {s.y + (s.v * terms.sine + s.a * terms.versine - rate_ * terms.lag),
            s.v + (s.a * terms.sine - (s.v + rate_) * terms.versine),
            s.a - s.a * terms.versine - (s.v + rate_) * terms.sine};
  }

  static HalfAngle half_angle(const Real& rise, const Real& run) {
    return run < 0 ? HalfAngle{-rise, -run} : HalfAngle{rise, run};
  }

  static Real angle(const HalfAngle& half) {
    const Real h = 2 * elementary::atan2(half.rise, half.run);
    return h > 0 ? h : Real(h + 2 * pi<Real>());
  }

  /// Restores the digits that the closed form lost, except where v only touches 0 and there is
  /// nothing to gain.
  void polish_turn(End& end, const Real& limit) const {
    const Real d = -end.at.v / end.at.a;
    const Real h = end.h + d;
    const Real size = d < 0 ? Real(-d) : d;
    if (end.at.a < 0 && size < end.h / 1000 && h <= limit) {
      end.h = h;
      if (size < end.h * first_order) {
        end.at = {end.at.y, Real(0), end.at.a - (end.at.v + rate_) * d};
      } else {
        end.at = at(h);
      }
    }
  }

  /// So short a step changes a by its first order and y by less than rounding.
  static constexpr double first_order = std::is_same_v<Real, double> ? 0x1p-28 : 0;

  Point start_;
  Real rate_;
  Real load_;
};

}  // namespace stillpoint
