// SPDX-License-Identifier: MIT
#pragma once

// What both kinds of pieces (linear_piece.hpp, harmonic_piece.hpp) tell the forced run.

namespace stillpoint {

enum class PieceEvent {
  none,     ///< none up to the end: v > 0 there and before
  arrival,  ///< y = 0, coming from y < 0
  turn,     ///< v = 0
};

/// The end of a piece: an event, or as far as was looked. `h` counts from the start of the piece.
template <class Real, class Point>
struct PieceEnd {
  PieceEvent event;
  Real h;
  Point at;
};

/// The smallest relative distance of a decision of the run from tipping: docs/forced.md section 7.
/// `slack` >= 0 is how far an event function stayed from deciding otherwise, `scale` the size of
/// what it compares.
template <class Real>
class TippingMargin {
 public:
  /// Whether that would make it smaller.
  [[nodiscard]] bool matters(const Real& slack, const Real& scale) const {
    return !any_ || slack * scale_ < slack_ * scale;
  }

  void decide(const Real& slack, const Real& scale) {
    if (matters(slack, scale)) {
      any_ = scale > 0;
      slack_ = slack;
      scale_ = scale;
    }
  }

  [[nodiscard]] bool any() const { return any_; }
  [[nodiscard]] Real value() const { return slack_ / scale_; }

 private:
  bool any_{false};
  Real slack_{0};
  Real scale_{1};
};

}  // namespace stillpoint
