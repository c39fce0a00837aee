// SPDX-License-Identifier: MIT
#pragma once

// The excitations as the forced run meets them: what loads the mass now, the sliding piece ahead,
// and the release from rest. In units where p = 1: w = W / p, h = p times a time.

#include <stillpoint/core/drive_phase.hpp>
#include <stillpoint/core/exact_sum.hpp>
#include <stillpoint/core/harmonic_piece.hpp>
#include <stillpoint/core/linear_piece.hpp>
#include <stillpoint/core/piece_end.hpp>

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

/// W = w + rate h.
template <class Real>
class LinearDrive {
 public:
  LinearDrive(Real w, Real rate) : w_(std::move(w)), rate_(std::move(rate)) {}

  [[nodiscard]] Real load() const { return w_; }

  void advance(const Real& h) { w_ += rate_ * h; }
  void advance(const ExactSum<Real>& h) { advance(h.value()); }

  /// Along a piece of this drive.
  void advance_to(const typename LinearPiece<Real>::End& end, int /*direction*/) { advance(end.h); }

  [[nodiscard]] LinearPiece<Real> piece(const Sliding<Real>& from) const {
    return {{from.y, from.v, from.a}, Real(from.direction) * rate_};
  }

  /// When |w + u| first exceeds phi, from where it does not; none where it never does.
  [[nodiscard]] std::optional<ExactSum<Real>> release(const Real& u, const Real& phi) const {
    if (rate_ == 0) {
      return std::nullopt;
    }
    const Real room = rate_ > 0 ? Real(phi - (w_ + u)) : Real(phi + (w_ + u));
    return ExactSum<Real>(room / (rate_ > 0 ? rate_ : Real(-rate_)));
  }

  /// Which way the mass goes after the release.
  [[nodiscard]] int release_direction() const { return rate_ > 0 ? -1 : 1; }

  /// The largest |w + u| ahead, where the drive lasts for ever.
  [[nodiscard]] Real largest_load(const Real& u) const {
    using std::abs;
    return abs(Real(u + w_));
  }

 private:
  Real w_;
  Real rate_;
};

/// W = K sin psi; K >= 0.
template <class Real>
class HarmonicDrive {
 public:
  HarmonicDrive(const DrivePhase<Real>& phase, Real k, TippingMargin<Real>& margin)
      : phase_(phase), k_(std::move(k)), margin_(margin), now_(phase.sin_cos()) {}

  [[nodiscard]] Real load() const { return k_ * now_.sine; }

  void advance(const Real& h) {
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
    const Real scale = Real(direction) / k_;
    now_ = {end.at.w * scale, end.at.q * scale};
  }

  [[nodiscard]] HarmonicPiece<Real> piece(const Sliding<Real>& from) {
    const Real k = Real(from.direction) * k_;
    const HarmonicPoint<Real> start{from.y, from.v, from.a, k * now_.sine, k * now_.cosine};
    return {HarmonicFlow<Real>(phase_, start, k), k_, guesses_, margin_};
  }

  void advance(const ExactSum<Real>& h) {
    phase_.advance(h);
    now_ = phase_.sin_cos();
  }

  /// When |w + u| first exceeds phi, from where it does not: (F18). As a sum of two, so that the
  /// phase there is as near to the crest as (F18) says, to all its digits.
  [[nodiscard]] std::optional<ExactSum<Real>> release(const Real& u, const Real& phi) {
    const Real spare = k_ - phi;
    const std::optional<Ahead> up = first_above(Real(spare + u), phase_.psi(), now_.cosine > 0);
    const std::optional<Ahead> down =
        first_above(Real(spare - u), Real(phase_.psi() + pi<Real>()), now_.cosine < 0);
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
        there.turn_by_half();
      }
      wait.add(there.short_of_crest(first.to_crest) / phase_.ratio());
    }
    return wait.value() > 0 ? wait : ExactSum<Real>();
  }

  [[nodiscard]] int release_direction() const { return direction_; }

  [[nodiscard]] Real largest_load(const Real& u) const {
    using std::abs;
    return abs(u) + k_;
  }

 private:
  struct Ahead {
    Real wait;
    Real to_crest;  ///< from there, in psi
  };

  /// When K sin psi, on its way up, first lies below K by `excess` only. `grows`: it is on its way
  /// up now.
  [[nodiscard]] std::optional<Ahead> first_above(const Real& excess, const Real& psi,
                                                 bool grows) const {
    using std::asin;
    using std::sqrt;
    if (!(excess > 0)) {
      return std::nullopt;
    }
    const Real turn = 2 * pi<Real>();
    // From the crossing up to the crest, with all digits where the crest hardly exceeds the level.
    const Real below = excess / (2 * k_);
    const Real to_crest = below < 1 ? Real(2 * asin(sqrt(below))) : pi<Real>();
    Real ahead = pi<Real>() / 2 - to_crest - psi;
    while (ahead < 0) {  // by one turn or two
      ahead += turn;
    }
    if (!(ahead < turn)) {
      ahead -= turn;
    }
    // The crossing lies behind, but the crest ahead: |w + u| = phi to the last bit, and growing.
    if (grows && turn - ahead < to_crest) {
      return Ahead{Real(0), to_crest};
    }
    return Ahead{Real(ahead / phase_.ratio()), to_crest};
  }

  DrivePhase<Real> phase_;
  Real k_;
  TippingMargin<Real>& margin_;
  typename DrivePhase<Real>::SinCos now_;
  EventGuesses<Real> guesses_;
  int direction_{1};
  int by_sums_{0};  ///< pieces since `now_` was taken from the phase
};

/// The piece that a drive makes of a sliding state.
template <class Drive, class Real>
using PieceOf = decltype(std::declval<Drive&>().piece(std::declval<const Sliding<Real>&>()));

/// A piece on which x = 0 was passed without a notch: where, is found when somebody wants it.
template <class Drive, class Real>
struct Crossing {
  using Piece = PieceOf<Drive, Real>;
  Piece piece;
  typename Piece::End end;

  // By reference, or a piece would be copied twice on the way in.
  // NOLINTNEXTLINE(modernize-pass-by-value)
  Crossing(const Piece& on, const typename Piece::End& until) : piece(on), end(until) {}
};

}  // namespace stillpoint
