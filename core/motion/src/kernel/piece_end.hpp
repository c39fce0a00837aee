// SPDX-License-Identifier: MIT
#pragma once

// What both kinds of pieces (linear_piece.hpp, harmonic_piece.hpp) report to the forced run.

#include <utility>

namespace stillpoint {

enum class PieceEvent {
  none,     ///< none up to the end: v > 0 there and before
  arrival,  ///< y = 0, coming from y < 0
  turn,     ///< v = 0
  touch,    ///< v = 0 and a = 0: v only touches 0
};

/// The end of a piece: an event, or the end of the search. `h` counts from the start of the piece.
template <class Real, class Point>
struct PieceEnd {
  PieceEvent event;
  Real h;
  Point at;
};

/// The smallest relative distance at which a decision of the run would change: docs/forced.md
/// section 7. `slack` >= 0 is the distance of an event function from the other decision, `scale`
/// the size of the values that it compares.
template <class Real>
class TippingMargin {
 public:
  TippingMargin() = default;
  /// The smallest so far.
  TippingMargin(Real slack, Real scale)
      : any_(true), slack_(std::move(slack)), scale_(std::move(scale)) {}

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
  [[nodiscard]] const Real& slack() const { return slack_; }
  [[nodiscard]] const Real& scale() const { return scale_; }

 private:
  bool any_{false};
  Real slack_{0};
  Real scale_{1};
};

}  // namespace stillpoint
