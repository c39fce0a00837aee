// SPDX-License-Identifier: MIT
#pragma once

// The excitations as the forced run uses them: the load on the mass now, the sliding piece ahead,
// and the release from rest. In units where p = 1: w = W / p, h = p times a time.

#include "kernel/damped_harmonic_piece.hpp"
#include "kernel/damped_piece.hpp"
#include "kernel/drive_phase.hpp"
#include "kernel/exact_sum.hpp"
#include "kernel/functions.hpp"
#include "kernel/harmonic_piece.hpp"
#include "kernel/hold.hpp"
#include "kernel/linear_piece.hpp"
#include "kernel/piece_end.hpp"

#include <algorithm>
#include <cmath>
#include <optional>
#include <utility>

namespace stillpoint {

/// A sliding state in its own direction (+1 or -1): y = direction * p x and so on.
template <class Real>
struct Sliding {
  Real y;
  Real v;
  Real a;
  int direction;
};

/// W is linear from one load to another, or constant.
template <class Real>
class LinearDrive {
 public:
  LinearDrive() : LinearDrive(Real(0), Real(0)) {}
  /// Constant: W / p and W.
  LinearDrive(const Real& w, const Real& full) : LinearDrive(w, full, w, full, Real(1)) {}
  /// From one to the other.
  LinearDrive(Real w, Real full, Real end_w, Real end_full, const Real& length)
      : w_(std::move(w)),
        rate_((end_w - w_) / length),
        end_w_(std::move(end_w)),
        full_(std::move(full)),
        end_full_(std::move(end_full)),
        length_(length) {}

  [[nodiscard]] const Real& w() const { return w_; }

  /// W itself with all its digits, or a turn within rounding of a tie would be repeated for ever.
  [[nodiscard]] Load<Real> load() const {
    Load<Real> now{w_, ExactSum<Real>(full_)};
    const Real rate = (end_full_ - full_) / length_;
    now.full.add_product(rate, elapsed_.high(), Real(rate * elapsed_.low()));
    return now;
  }

  /// The load is as accurate as its own digits.
  [[nodiscard]] Real amplitude() const { return Real(0); }

  void advance(const Real& h) {
    w_ += rate_ * h;
    elapsed_.add(h);
  }
  void advance(const ExactSum<Real>& h) { advance(h.value()); }

  /// Along a piece of this drive.
  void advance_to(const typename LinearPiece<Real>::End& end, int /*direction*/) { advance(end.h); }

  [[nodiscard]] LinearPiece<Real> piece(const Sliding<Real>& from) const {
    return {{from.y, from.v, from.a}, Real(from.direction) * rate_, magnitude(w_)};
  }

  [[nodiscard]] DampedPiece<Real> damped_piece(const Sliding<Real>& from,
                                               const DampedSwing<Real>& swing) const {
    return {{from.y, from.v, from.a}, Real(from.direction) * rate_, magnitude(w_), swing};
  }

  [[nodiscard]] typename LinearPiece<Real>::End first_event(const LinearPiece<Real>& piece,
                                                            const Real& limit,
                                                            bool want_arrival) const {
    return rate_ == 0 ? piece.first_event_of_constant_load(limit, want_arrival)
                      : piece.first_event(limit, want_arrival);
  }

  /// When a load that is held first exceeds friction; none if it never does.
  template <class AnyHold>
  [[nodiscard]] std::optional<ExactSum<Real>> release(const AnyHold& hold) const {
    using std::max;
    const int sign = rate_ > 0 ? 1 : -1;
    if (rate_ == 0 || !(hold.excess({end_w_, ExactSum<Real>(end_full_)}, sign) > 0)) {
      return std::nullopt;
    }
    const Real room = -hold.beyond(Real(Real(sign) * (w_ + hold.u())), sign);
    return ExactSum<Real>(Real(max(Real(0), room) / magnitude(rate_)));
  }

  /// Between its ends this load has no crest.
  template <class AnyHold>
  void crests(const AnyHold& /*hold*/, const Real& /*wait*/, bool /*released*/) const {}

  /// The direction of the mass after the release.
  [[nodiscard]] int release_direction() const { return rate_ > 0 ? -1 : 1; }

  /// The largest |w + u| ahead, if the drive lasts for ever, and its excess over friction.
  [[nodiscard]] Real largest_load(const Real& u) const { return magnitude(Real(u + w_)); }
  template <class AnyHold>
  [[nodiscard]] Real largest_excess(const AnyHold& hold) const {
    const Load<Real> now = load();
    return hold.excess(now, hold.sign(now));
  }

 private:
  Real w_;
  Real rate_;
  Real end_w_;
  Real full_;  ///< W at the start and at the end
  Real end_full_;
  Real length_;
  ExactSum<Real> elapsed_;  ///< or times below its ulp would be lost, and with them a tie
};

/// W = K sin psi + C; K >= 0.
template <class Real>
class HarmonicDrive {
 public:
  /// `k` is K and `constant` C.
  HarmonicDrive(const DrivePhase<Real>& phase, Load<Real> k, Load<Real> constant,
                TippingMargin<Real>& margin)
      : phase_(phase),
        k_(std::move(k.w)),
        full_k_(k.full.value()),
        c_(std::move(constant.w)),
        full_c_(constant.full.value()),
        inverse_k_(k_ == 0 ? Real(0) : Real(1 / k_)),
        margin_(margin),
        now_(phase.sin_cos()) {}

  /// The factor on an error of the phase.
  [[nodiscard]] const Real& amplitude() const { return k_; }

  [[nodiscard]] Real w() const { return k_ * now_.sine + c_; }
  [[nodiscard]] Load<Real> load() const {
    return {w(), ExactSum<Real>(Real(full_k_ * now_.sine + full_c_))};
  }

  template <class Time>  // a number or an exact sum
  void advance(const Time& h) {
    phase_.advance(h);
    now_ = phase_.sin_cos();
  }

  /// Along a piece of this drive, whose end has the sine and cosine of the phase, by sums of
  /// angles: docs/forced.md section 2. Their errors must not add up.
  void advance_to(const typename HarmonicPiece<Real>::End& end, int direction) {
    constexpr int pieces_by_sums = 3;
    if (k_ == 0 || ++by_sums_ > pieces_by_sums) {
      by_sums_ = 0;
      advance(end.h);
      return;
    }
    phase_.advance(end.h);
    const Real scale = Real(direction) * inverse_k_;
    now_ = {end.at.w * scale, end.at.q * scale};
  }

  [[nodiscard]] HarmonicPiece<Real> piece(const Sliding<Real>& from) {
    return {phase_, start_of(from), Real(from.direction) * k_, k_, guesses_, margin_};
  }

  [[nodiscard]] DampedHarmonicPiece<Real> damped_piece(const Sliding<Real>& from,
                                                       const DampedSwing<Real>& swing) const {
    return {start_of(from), phase_.ratio(), swing.zeta(), margin_, magnitude(c_)};
  }

  /// Where a piece from there begins. The flow does not see C, which only moves its centre: (F39).
  [[nodiscard]] HarmonicPoint<Real> start_of(const Sliding<Real>& from) const {
    const Real k = Real(from.direction) * k_;
    HarmonicPoint<Real> start{from.y, from.v, from.a, k * now_.sine, k * now_.cosine};
    if (start.v == 0 && start.a == 0 && start.q > 0) {
      start.q = Real(0);  // released at a crest: by rounding the load seems to recede
    }
    return start;
  }

  /// The first guess for the next arrival; returns what it would have been.
  Real expects_arrival_after(const Real& h) { return std::exchange(guesses_.arrival, h); }

  /// When a load that is held first exceeds friction: (F18). A sum of two numbers, so that the
  /// phase there has all digits of its distance to the crest.
  template <class AnyHold>
  [[nodiscard]] std::optional<ExactSum<Real>> release(const AnyHold& hold) {
    room_up_ = room(hold, 1);
    room_down_ = room(hold, -1);
    const std::optional<Ahead> up = first_above(room_up_, phase_.psi(), now_.cosine > 0);
    const std::optional<Ahead> down =
        first_above(room_down_, Real(phase_.psi() + pi<Real>()), now_.cosine < 0);
    if (!up && !down) {
      return std::nullopt;
    }
    direction_ = up && (!down || up->wait < down->wait) ? -1 : 1;
    const Ahead& first = direction_ < 0 ? *up : *down;
    ExactSum<Real> wait(first.wait);
    if (first.wait > 0) {
      DrivePhase<Real> there = phase_;
      there.advance(first.wait);
      if (direction_ > 0) {
        there.turn_by(Real(0.5));
      }
      wait.add(there.short_of_crest(first.to_crest) / phase_.ratio());
    }
    return wait.value() > 0 ? wait : ExactSum<Real>();
  }

  [[nodiscard]] int release_direction() const { return direction_; }

  /// How close the crests of the load come to friction during a wait after release(), the last
  /// crest included.
  template <class AnyHold>
  void crests(const AnyHold& hold, const Real& wait, bool released) const {
    const Real angle = wait * phase_.ratio();
    const auto decide = [&](int sign, const Real& room, const Real& ahead) {
      const Real to_crest = ahead < 0 ? Real(ahead + 2 * pi<Real>()) : ahead;
      if ((released && sign == -direction_) || to_crest < angle) {
        margin_.decide(room < 0 ? Real(-room) : room, hold.size(Real(k_ + magnitude(c_))));
      }
    };
    decide(1, room_up_, Real(pi<Real>() / 2 - phase_.psi()));
    decide(-1, room_down_, Real(-pi<Real>() / 2 - phase_.psi()));
  }
  [[nodiscard]] Real largest_load(const Real& u) const { return magnitude(u) + k_ + magnitude(c_); }
  template <class AnyHold>
  [[nodiscard]] Real largest_excess(const AnyHold& hold) const {
    if constexpr (AnyHold::symmetric) {
      return room(hold, hold.u() < 0 ? -1 : 1);
    } else {
      return std::max(room(hold, -1), room(hold, 1));
    }
  }

 private:
  struct Ahead {
    Real wait;
    Real to_crest;  ///< from there, in psi
  };

  /// By how much the crest of the load in the direction `sign` exceeds friction.
  template <class AnyHold>
  [[nodiscard]] Real room(const AnyHold& hold, int sign) const {
    const Real most = crest(sign);
    const Real spare = hold.beyond(most, sign);  // first, or u would be rounded away
    return hold.sharpened(Real(spare + Real(sign) * hold.u()),
                          {most, ExactSum<Real>(Real(Real(sign) * full_k_ + full_c_))}, sign);
  }
  [[nodiscard]] Real crest(int sign) const { return k_ + Real(sign) * c_; }

  /// When the rising load first passes the level that its crest exceeds by `room`. `grows`: it is
  /// rising now.
  [[nodiscard]] std::optional<Ahead> first_above(const Real& room, const Real& psi,
                                                 bool grows) const {
    using std::sqrt;
    if (!(room > 0)) {
      return std::nullopt;
    }
    const Real turn = 2 * pi<Real>();
    // From the crossing up to the crest, with all digits even if the crest barely exceeds the
    // level.
    const Real below = room / (2 * k_);
    const Real to_crest = below < 1 ? Real(2 * elementary::asin(Real(sqrt(below)))) : pi<Real>();
    Real ahead = pi<Real>() / 2 - to_crest - psi;
    while (ahead < 0) {  // by one turn or two
      ahead += turn;
    }
    if (!(ahead < turn)) {
      ahead -= turn;
    }
    // The crossing is past, the crest ahead: |w + u| = phi to the last bit, and growing.
    if (grows && turn - ahead < to_crest) {
      return Ahead{Real(0), to_crest};
    }
    return Ahead{Real(ahead / phase_.ratio()), to_crest};
  }

  DrivePhase<Real> phase_;
  Real k_;
  Real full_k_;
  Real c_;
  Real full_c_;
  Real inverse_k_;  ///< unused where k = 0
  TippingMargin<Real>& margin_;
  elementary::SinCosOf<Real> now_;
  EventGuesses<Real> guesses_;
  int direction_{1};
  Real room_up_{0};  ///< the level that a crest exceeds, at the last search for a release
  Real room_down_{0};
  int by_sums_{0};  ///< pieces since `now_` was taken from the phase
};

/// The sliding piece that a drive makes of a state, where friction obeys a law.
template <class Law, class Drive, class Real>
[[nodiscard]] auto piece_under(const Law& law, Drive& drive, const Sliding<Real>& from) {
  if constexpr (Law::damped) {
    return drive.damped_piece(from, law.swing());
  } else {
    return drive.piece(from);
  }
}

/// A piece on which x = 0 was passed without a notch; the place is found only on demand.
template <class Piece>
struct Crossing {
  Piece piece;
  typename Piece::End end;

  // By reference; otherwise a piece would be copied twice.
  // NOLINTNEXTLINE(modernize-pass-by-value)
  Crossing(const Piece& on, const typename Piece::End& until) : piece(on), end(until) {}
};

}  // namespace stillpoint
