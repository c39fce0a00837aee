// SPDX-License-Identifier: MIT
#pragma once

// The sliding mass on the intervals of a record in which no event comes, docs/forced.md (F21).

#include "kernel/forced_state.hpp"
#include "kernel/functions.hpp"
#include "kernel/linear_piece.hpp"
#include "kernel/record_intervals.hpp"
#include "kernel/record_samples.hpp"

#include <algorithm>
#include <cstddef>
#include <limits>
#include <optional>

namespace stillpoint {

/// Those of an interval of length h.
template <class Real>
void update(IntervalTerms<Real>& terms, const Real& h) {
  if (h != terms.h) {
    terms = IntervalTerms<Real>(h);
  }
}

/// A state of the slide in its own direction, with the load there.
template <class Real>
struct SlidePoint {
  Real y;
  Real v;
  Real a;
  Real w;

  /// (F16) over a whole interval, to the load `next_w`. There a does not need y, so v and a wait
  /// only for each other; `afresh`: a is computed from y, so that rounding errors cannot make the
  /// two drift apart.
  [[nodiscard]] SlidePoint after(const IntervalTerms<Real>& t, const Real& next_w, const Real& phi,
                                 bool afresh) const {
    const Real rise = next_w - w;
    const Real v_sine = v * t.sine;
    const Real a_versine = a * t.versine;
    const Real next_y = y + (v_sine + a_versine - rise * t.lag);
    return {
        next_y, (v - v * t.versine) + (a * t.sine - rise * t.bend),
        afresh ? Real(-(next_y + phi + next_w)) : Real((a - a_versine) - (v_sine + rise * t.pull)),
        next_w};
  }

  /// The piece from here to the next sample, and its end.
  [[nodiscard]] LinearPiece<Real> piece_to(const SlidePoint& next,
                                           const IntervalTerms<Real>& t) const {
    return {{y, v, a}, Real((next.w - w) / t.h)};
  }
  [[nodiscard]] typename LinearPiece<Real>::End as_end(const IntervalTerms<Real>& t) const {
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
  ForcedState<Real>& s = run.state();
  const Real sign(s.direction);
  const Real signed_inverse = sign * samples.inverse_p();
  const Real* const values = samples.record().values.data();
  SlidePoint<Real> now{sign * s.u, sign * s.v, Real(0), values[i] * signed_inverse};
  if (!(now.v > 0)) {
    return i;
  }
  const Real phi = run.law().phi_ahead(now.y);
  now.a = -(now.y + phi + now.w);
  Real largest = s.acceleration;
  const Real edge = run.law().edge_ahead(now.y);
  Real look = now.y < 0 ? std::min(edge, Real(0)) : edge;
  update(terms, samples.times().length(i));
  IntervalTerms<Real> t = terms;  // a copy, which may stay in registers
  // An interval may hold the largest |a| only where |a| exceeds `matters` at one of its ends:
  // where it does so at `at`, any |a| at the other one will do.
  const auto threshold = [&](const SlidePoint<Real>& at) {
    const Real matters = largest * t.cosine;
    return magnitude(at.a) > matters ? Real(-1) : matters;
  };
  Real matters = threshold(now);
  for (; i < last; ++i) {
    if constexpr (!even) {
      update(terms, samples.times().length(i));
      t = terms;
      matters = threshold(now);
    }
    const SlidePoint<Real> next =
        now.after(t, Real(values[i + 1] * signed_inverse), phi, i % afresh == 0);
    if (!(std::min(now.v, next.v) > std::max(t.least_v, Real(t.fall * (next.w - now.w))))) {
      break;
    }
    if constexpr (Run::AnyWatcher::watches) {
      if (next.y < edge) {
        run.watcher().piece(samples.times().at(i), s.direction, now.piece_to(next, t));
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
    if (magnitude(next.a) > matters) [[unlikely]] {
      largest = now.piece_to(next, t).largest_acceleration(next.as_end(t), largest);
      matters = threshold(next);
    }
    now = next;
  }
  s.acceleration = largest;
  s.u = sign * now.y;
  s.v = sign * now.v;
  return i;
}

}  // namespace stillpoint
