// SPDX-License-Identifier: MIT
#pragma once

// The sliding mass on the intervals of a record in which no event comes, docs/forced.md (F21), with
// damping docs/damping.md (D6) and (D7).

#include "kernel/damped_piece.hpp"
#include "kernel/forced_state.hpp"
#include "kernel/functions.hpp"
#include "kernel/linear_piece.hpp"
#include "kernel/record_intervals.hpp"
#include "kernel/record_samples.hpp"

#include <algorithm>
#include <cstddef>
#include <limits>
#include <optional>
#include <type_traits>

namespace stillpoint {

/// Those of an interval of length h.
template <class Real, class Law>
void update(IntervalTerms<Real>& terms, const Real& h, const Law& law) {
  if (h != terms.h) {
    if constexpr (Law::damped) {
      terms = IntervalTerms<Real>::damped(h, law.swing());
    } else {
      terms = IntervalTerms<Real>(h);
    }
  }
}

/// A state of the slide in its own direction, with the load there.
template <class Real, bool damped>
struct SlidePoint {
  using Piece = std::conditional_t<damped, DampedPiece<Real>, LinearPiece<Real>>;

  Real y;
  Real v;
  Real a;
  Real w;

  /// (F16) over a whole interval, to the load `next_w`. Without damping a does not need y there, so
  /// v and a wait only for each other; `afresh`: a is computed from y, so that rounding errors
  /// cannot make the two drift apart.
  [[nodiscard]] SlidePoint after(const IntervalTerms<Real>& t, const Real& next_w, const Real& phi,
                                 bool afresh) const {
    const Real rise = next_w - w;
    const Real v_sine = v * t.sine;
    const Real a_versine = a * t.versine;
    const Real reach = damped ? Real(v * t.reach) : v_sine;
    const Real drag = damped ? Real(a * t.drag) : a_versine;
    SlidePoint next{y + (reach + a_versine - rise * t.lag),
                    (v - v * t.versine) + (a * t.sine - rise * t.bend),
                    (a - drag) - (v_sine + rise * t.pull), next_w};
    if (afresh) {
      next.set_a(t, phi);
    }
    return next;
  }

  /// From the rest of the state.
  void set_a(const IntervalTerms<Real>& t, const Real& phi) {
    const Real force = y + phi + w;
    a = -(damped ? Real(force + t.twice_zeta * v) : force);
  }

  /// Not (D7): whether the structure may feel more between here and the next sample than `felt`.
  [[nodiscard]] bool may_feel_more(const SlidePoint& next, const IntervalTerms<Real>& t,
                                   const Real& tilt, const Real& felt) const {
    const Real from = v + t.twice_zeta * a;
    const Real to = next.v + t.twice_zeta * next.a;
    const Real least = magnitude(tilt);
    if (std::min(from, to) > least || std::max(from, to) < -least) {
      return false;
    }
    const Real ends = std::max(magnitude(Real(a + w)), magnitude(Real(next.a + next.w)));
    return t.swell * (ends + t.lift * std::max(magnitude(w), magnitude(next.w))) > felt;
  }

  /// The most that it feels between here and there.
  void feel(const SlidePoint& next, const IntervalTerms<Real>& t, const Real& phi,
            Real& most) const {
    most = piece_to(next, t).largest_transmitted(phi, next.as_end(t), most);
  }

  /// The piece from here to the next sample, and its end.
  [[nodiscard]] Piece piece_to(const SlidePoint& next, const IntervalTerms<Real>& t) const {
    const Real rate = (next.w - w) / t.h;
    if constexpr (damped) {
      return {{y, v, a}, rate, magnitude(w), *t.swing};
    } else {
      return {{y, v, a}, rate};
    }
  }
  [[nodiscard]] typename Piece::End as_end(const IntervalTerms<Real>& t) const {
    return {PieceEvent::none, t.h, {y, v, a}};
  }
};

/// From sample i on while (F21) proves that no event comes; returns the first sample without such a
/// proof, or a later one after a stretch that the hook should see. `even`: all intervals have one
/// length.
template <bool even, class Run, class Real, class AnyCrossing>
[[gnu::noinline]] std::size_t slide_along(Run& run, const RecordSamples<Real>& samples,
                                          IntervalTerms<Real>& terms,
                                          std::optional<AnyCrossing>& crossing, std::size_t i,
                                          std::size_t last) {
  constexpr std::size_t afresh = 16;  // at each such sample a is computed from y
  constexpr bool damped = Run::AnyLaw::damped;
  ForcedState<Real>& s = run.state();
  const Real sign(s.direction);
  const Real signed_inverse = sign * samples.inverse_p();
  const Real* const values = samples.record().values.data();
  using Slide = SlidePoint<Real, damped>;
  Slide now{sign * s.u, sign * s.v, Real(0), values[i] * signed_inverse};
  if (!(now.v > 0)) {
    return i;
  }
  const Real phi = run.law().phi_ahead(now.y);
  Real largest = s.acceleration;
  const Real edge = run.law().edge_ahead(now.y);
  Real look = now.y < 0 ? std::min(edge, Real(0)) : edge;
  update(terms, samples.times().length(i), run.law());
  IntervalTerms<Real> t = terms;  // a copy, which may stay in registers
  now.set_a(t, phi);
  // An interval may hold the largest |a| only where |a| exceeds `matters` at one of its ends:
  // where it does so at `at`, any |a| at the other one will do.
  const auto threshold = [&](const Slide& at) {
    const Real matters = largest * t.cosine;
    return magnitude(at.a) > matters ? Real(-1) : matters;
  };
  Real matters = threshold(now);
  for (; i < last; ++i) {
    if constexpr (!even) {
      update(terms, samples.times().length(i), run.law());
      t = terms;
      matters = threshold(now);
    }
    const Slide next = now.after(t, Real(values[i + 1] * signed_inverse), phi, i % afresh == 0);
    const Real tilt = t.fall * (next.w - now.w);
    if (!(std::min(now.v, next.v) > std::max(t.least_v, tilt))) {
      break;
    }
    if constexpr (Run::AnyWatcher::watches) {
      if (next.y < edge) {
        run.watcher().piece(samples.times().at(i), s.direction, now.piece_to(next, t), t.h,
                            Real(sign * now.w));
      }
    }
    if (next.y >= look) [[unlikely]] {
      if (next.y >= edge) {
        break;
      }
      look = edge;
      s.now = samples.times().at(i);
      run.cross(now.piece_to(next, t), next.as_end(t), crossing);
    }
    if constexpr (damped) {
      if (now.may_feel_more(next, t, tilt, s.transmitted.slid)) [[unlikely]] {
        now.feel(next, t, phi, s.transmitted.slid);
      }
    }
    if (magnitude(next.a) > matters) [[unlikely]] {
      largest = now.piece_to(next, t).largest_acceleration(next.as_end(t), largest);
      matters = threshold(next);
    }
    // One by one: a copy of all at once would wait until each has been stored.
    now.y = next.y;
    now.v = next.v;
    now.a = next.a;
    now.w = next.w;
  }
  s.acceleration = largest;
  s.u = sign * now.y;
  s.v = sign * now.v;
  return i;
}

}  // namespace stillpoint
