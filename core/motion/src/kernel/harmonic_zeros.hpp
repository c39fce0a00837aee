// SPDX-License-Identifier: MIT
#pragma once

// Zeros of v and of y on a harmonic piece, found fast: docs/forced.md (F11). The caller proves that
// a zero is the first one. Symbols as in harmonic_point.hpp.

#include "kernel/functions.hpp"
#include "kernel/harmonic_flow.hpp"
#include "kernel/piece_end.hpp"

#include <algorithm>
#include <array>

namespace stillpoint {

template <class Real>
class HarmonicZeros {
 public:
  using Point = HarmonicPoint<Real>;
  using End = PieceEnd<Real, Point>;

  struct Located {
    Real h;
    Point at;
  };

  HarmonicZeros(const DrivePhase<Real>& phase, const Point& start, const Real& mirrored_k)
      : flow_(phase, start, mirrored_k) {}

  [[nodiscard]] const HarmonicFlow<Real>& flow() const { return flow_; }

  /// The steps of (F11) shrink so fast that after one of this length the next is below rounding.
  [[nodiscard]] Real small_step(const Real& h) const {
    return eighth_root_of_epsilon<Real>() * std::min(h, flow_.time_scale());
  }

  /// Newton's method on `series`, of v or of y, of the state from h on until it converges; the
  /// closed form is evaluated anew after every long step, and after one back towards the start,
  /// where the state is small and would keep the larger one's errors. The zero goes to `end`; false
  /// if it does not converge.
  template <auto series>
  [[nodiscard]] bool improved(Real h, const Real& horizon, End& end) const {
    const Real longest = flow_.time_scale() / 8;
    Point at = flow_.at(h);
    for (int tries = 0; tries < 12; ++tries) {
      const HarmonicTaylor<Real> taylor(at, flow_.r());
      const Real last = small_step(h);
      const Real d = polynomial_root(taylor.*series, last);
      const Real size = magnitude(d);
      if (!(size < 2) || !(h + d > 0) || h + d > horizon) {
        return false;
      }
      h += d;
      if (size > std::min(longest, h)) {
        at = flow_.at(h);
        continue;
      }
      if (size <= last) {
        end.h = h;
        end.at = nudged(at, taylor, flow_.r(), d);
        return true;
      }
      at = shifted(at, flow_.r(), d);
    }
    return false;
  }

  /// The zero of a function that is < 0 (or starts so) at `low` and >= 0 at `high`: by the steps of
  /// (F11) kept inside the bracket, which halving shrinks where they fail.
  template <auto series, class Value>
  [[nodiscard]] Located bracketed(Real low, Real high, Value value) const {
    Real h = low + (high - low) / 2;
    Point at = flow_.at(h);
    while (true) {
      (value(at) < 0 ? low : high) = h;
      const HarmonicTaylor<Real> taylor(at, flow_.r());
      const Real last = small_step(h);
      const Real d = polynomial_root(taylor.*series, last);
      const Real size = magnitude(d);
      Real next = h + d;
      if (next >= low && next <= high && size <= std::min(Real(flow_.time_scale() / 8), next)) {
        if (size <= last) {
          return {next, nudged(at, taylor, flow_.r(), d)};
        }
        at = shifted(at, flow_.r(), d);
      } else {
        if (!(next > low && next < high)) {
          next = low + (high - low) / 2;
        }
        if (!(next > low && next < high)) {
          return {high, flow_.at(high)};
        }
        at = flow_.at(next);
      }
      h = next;
    }
  }

 private:
  HarmonicFlow<Real> flow_;
};

}  // namespace stillpoint
