// SPDX-License-Identifier: MIT
#pragma once

// The first event of a sliding piece under W = k sin(lambda tau + phase): docs/forced.md section 4.
// A candidate is found fast and without proof; then v > 0 up to it is proved from the states at
// both ends, by halving if that is not enough. An interval halved below the resolution of time
// is a graze, not an event. Symbols as in harmonic_point.hpp.

#include "kernel/functions.hpp"
#include "kernel/harmonic_crest.hpp"
#include "kernel/harmonic_flow.hpp"
#include "kernel/harmonic_zeros.hpp"
#include "kernel/piece_end.hpp"
#include "kernel/positivity.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>
#include <utility>

namespace stillpoint {

/// The times of the last event of each kind after the start of its piece: in a settled motion the
/// next one comes after the same time. Only a first guess; 0 if there is none yet.
template <class Real>
struct EventGuesses {
  Real arrival{0};
  Real turn_after_turn{0};
  Real turn_after_passage{0};
  Real turn_after_release{0};
};

template <class Real>
class HarmonicPiece {
 public:
  using Point = HarmonicPoint<Real>;
  using End = PieceEnd<Real, Point>;
  using Located = typename HarmonicZeros<Real>::Located;

  /// Arguments as of the flow; `k` is the amplitude.
  HarmonicPiece(const DrivePhase<Real>& phase, const Point& start, const Real& mirrored_k, Real k,
                EventGuesses<Real>& guesses, TippingMargin<Real>& margin)
      : zeros_(phase, start, mirrored_k), k_(std::move(k)), guesses_(guesses), margin_(margin) {}

  [[nodiscard]] const HarmonicFlow<Real>& flow() const { return zeros_.flow(); }

  /// The first turn or, if asked for, arrival up to `limit`. A piece may end before without any, so
  /// that no time after its start becomes so long that it is rounded.
  [[nodiscard]] End first_event(const Real& limit, bool want_arrival) {
    using std::min;
    const Real horizon = min(limit, Real(2 * pi<Real>()));
    End end{};
    if (worth_guessing(want_arrival) && guessed(horizon, want_arrival, end)) {
      return end;
    }
    end = march(horizon);
    if (want_arrival && !(end.at.y < 0)) {
      end = arrival_before(end);
      guesses_.arrival = end.h;
    } else if (end.event == PieceEvent::turn) {
      turn_guess() = end.h;
    }
    return end;
  }

  /// Where y = 0 on a piece that ends with y >= 0, started from y < 0 and has v > 0 between.
  [[nodiscard]] End arrival_before(const End& end) const {
    const auto [h, at] =
        zeros_.template bracketed<of_y>(Real(0), end.h, [](const Point& point) { return point.y; });
    return {PieceEvent::arrival, h, at};
  }

  /// The largest |a| up to `end`, or `so_far` where that is larger.
  [[nodiscard]] Real largest_acceleration(const End& end, const Real& so_far) const {
    return HarmonicCrest<Real>(flow(), k_).largest(end.h, end.at, so_far);
  }

 private:
  static constexpr auto of_v = &HarmonicTaylor<Real>::v;
  static constexpr auto of_y = &HarmonicTaylor<Real>::y;

  /// Within more turns of the forcing than this a guess is not worth its cost. Also the number of
  /// turns after which times are counted anew, so that they are not rounded.
  static Real few_turns() { return Real(16); }

  [[nodiscard]] bool worth_guessing(bool want_arrival) const {
    const Real& guess = want_arrival ? guesses_.arrival : turn_guess();
    return flow().r() * (guess > 0 ? guess : Real(2)) <= few_turns();
  }

  /// Times closer than this are the same: a few ulp of the time scale or of h itself.
  [[nodiscard]] Real resolution(const Real& h) const {
    return 2 * std::numeric_limits<Real>::epsilon() * std::max(h, Real(flow().time_scale() / 16));
  }

  [[nodiscard]] Real& turn_guess() const {
    const Point& start = flow().start();
    return start.v != 0   ? guesses_.turn_after_passage
           : start.a != 0 ? guesses_.turn_after_turn
                          : guesses_.turn_after_release;
  }

  /// When the turn or, from rest, the arrival would come under a constant load.
  [[nodiscard]] Real under_constant_load(bool want_arrival) const {
    using std::sqrt;
    const Point& start = flow().start();
    if (start.v != 0) {
      return elementary::atan2(start.v, Real(-start.a));
    }
    if (want_arrival && -start.y < 2 * start.a) {
      return 2 * elementary::asin(Real(sqrt(Real(-start.y / (2 * start.a)))));
    }
    return start.a != 0 ? pi<Real>() : Real(4);
  }

  /// The event found from a guess and proved to be the first goes to `end`, which is passed on
  /// without a copy; false if there is none.
  [[nodiscard]] bool guessed(const Real& horizon, bool want_arrival, End& end) {
    Real& guess = want_arrival ? guesses_.arrival : turn_guess();
    const Real begin = guess > 0 ? guess : under_constant_load(want_arrival);
    const Real h = std::min(begin, horizon);
    if (!(want_arrival ? zeros_.template improved<of_y>(h, horizon, end)
                       : zeros_.template improved<of_v>(h, horizon, end))) {
      return false;
    }
    end.event = want_arrival ? PieceEvent::arrival : PieceEvent::turn;
    const Point& at = end.at;
    const Real off = last_correction<Real>() * zeros_.small_step(end.h);
    const bool is_zero = want_arrival ? at.v > 0 && magnitude(at.y) <= at.v * off
                                      : at.a < 0 && magnitude(at.v) <= -at.a * off;
    if (!is_zero) {
      return false;
    }
    guess = end.h;
    if (const std::optional<Located> earlier =
            turn_between(flow().start(), Real(0), end.at, end.h)) {
      if (want_arrival && !(earlier->at.y < 0)) {
        return false;
      }
      end = {PieceEvent::turn, earlier->h, earlier->at};
    }
    return true;
  }

  /// From the left in steps on which the motion hardly bends, or along which the slow part of a
  /// fast forced motion outweighs its ripple.
  [[nodiscard]] End march(const Real& horizon) {
    const Real step = flow().time_scale() / 2;
    Real h{0};
    Point left = flow().start();
    while (h < horizon) {
      const Real jump = ripple_free(left);
      if (jump > step) {
        h = std::min(Real(h + jump), horizon);
        left = flow().at(h);
        if (flow().r() * jump > few_turns()) {
          return {PieceEvent::none, h, left};
        }
        continue;
      }
      const Real next = std::min(Real(h + step), horizon);
      const Point right = flow().at(next);
      if (const std::optional<Located> turn =
              right.v > 0 ? turn_between(left, h, right, next) : turn_in(left, h, next)) {
        return {PieceEvent::turn, turn->h, turn->at};
      }
      h = next;
      left = right;
    }
    return {PieceEvent::none, h, left};
  }

  /// (F15): how long the slow part stays above the ripple; 0 where it is not.
  [[nodiscard]] Real ripple_free(const Point& point) const {
    using std::sqrt;
    const Real& r = flow().r();
    if (!flow().fast()) {
      return Real(0);
    }
    const Real c = 1 / (r * r - 1);
    const Real ripple = c * r * k_;
    const Real v = point.v - c * r * point.q;
    const Real a = point.a + c * r * r * point.w;
    if (!(v > ripple)) {
      return Real(0);
    }
    const Real most =
        elementary::atan2(a, v) + elementary::acos(Real(ripple / sqrt(v * v + a * a)));
    return most * (1 - 64 * std::numeric_limits<Real>::epsilon());
  }

  /// The first turn between two points with v > 0, or v = 0 and no turn, at the left and v <= 0 at
  /// the right.
  [[nodiscard]] std::optional<Located> turn_in(const Point& left, const Real& from,
                                               const Real& to) const {
    const auto [h, at] =
        zeros_.template bracketed<of_v>(from, to, [](const Point& point) { return -point.v; });
    if (std::optional<Located> earlier = turn_between(left, from, at, h)) {
      return earlier;
    }
    return Located{h, at};
  }

  /// The first turn strictly between two points with v >= 0 at both; none if v > 0 there.
  [[nodiscard]] std::optional<Located> turn_between(const Point& left, const Real& from,
                                                    const Point& right, const Real& to) const {
    const Real length = to - from;
    const bool dips = left.a < 0 && right.a > 0;
    const bool proved = positive_between(left, right, flow().r(), k_, length);
    if (proved && dips && length < flow().time_scale() / 16) {
      const Real least = left.v + left.a * length * (left.a / (left.a - right.a)) / 2;
      margin_.decide(std::max(least, Real(0)), speed_scale(left));
    }
    if (proved && (!dips || length < flow().time_scale() / 16)) {
      return std::nullopt;
    }
    const Real middle = from + length / 2;
    if (!(length > resolution(to)) || !(middle > from) || !(middle < to)) {
      return std::nullopt;
    }
    const Point at = flow().at(middle);
    if (!(at.v > 0)) {
      return turn_in(left, from, middle);
    }
    if (std::optional<Located> turn = turn_between(left, from, at, middle)) {
      return turn;
    }
    return turn_between(at, middle, right, to);
  }

  /// The scale of v: the speed that the forces produce within the time scale.
  [[nodiscard]] Real speed_scale(const Point& at) const {
    return at.v + (magnitude(at.a) + k_) * flow().time_scale();
  }

  HarmonicZeros<Real> zeros_;
  Real k_;
  EventGuesses<Real>& guesses_;
  TippingMargin<Real>& margin_;
};

}  // namespace stillpoint
