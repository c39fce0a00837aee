// SPDX-License-Identifier: MIT
#pragma once

// The sliding mass on the intervals of a record in which no event comes, docs/forced.md (F21).

#include "kernel/forced_state.hpp"
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
  Real y = sign * s.u;
  const Real phi = run.law().phi_ahead(y);
  Real v = sign * s.v;
  Real w = values[i] * signed_inverse;
  Real a = -(y + phi + w);
  Real largest = s.acceleration;
  if (!(v > 0)) {
    return i;
  }
  Real arrival = run.law().edge_ahead(y);
  const bool passes = !Run::AnyLaw::in_zones && run.map().notch == 0;
  update(terms, samples.times().length(i));
  IntervalTerms<Real> t = terms;  // a copy, which may stay in registers
  // An interval may hold the largest |a| only where |a| exceeds `matters` at one of its ends:
  // where it does so at `now`, any |a| at the other one will do.
  const auto threshold = [&](const Real& now) {
    const Real matters = largest * t.cosine;
    return Run::magnitude(now) > matters ? Real(-1) : matters;
  };
  Real matters = threshold(a);
  for (; i < last; ++i) {
    if constexpr (!even) {
      update(terms, samples.times().length(i));
      t = terms;
      matters = threshold(a);
    }
    const Real next_w = values[i + 1] * signed_inverse;
    const Real rise = next_w - w;
    const Real v_sine = v * t.sine;
    const Real a_versine = a * t.versine;
    const Real next_v = (v - v * t.versine) + (a * t.sine - rise * t.bend);
    const Real next_y = y + (v_sine + a_versine - rise * t.lag);
    if (!(std::min(v, next_v) > std::max(t.least_v, Real(t.fall * rise)))) {
      break;
    }
    // By (F16) a does not need y, so v and a wait only for each other. Now and then a is computed
    // from y again, so that rounding errors cannot make the two drift apart.
    const Real next_a = i % afresh == 0 ? Real(-(next_y + phi + next_w))
                                        : Real((a - a_versine) - (v_sine + rise * t.pull));
    const auto piece = [&] { return LinearPiece<Real>({y, v, a}, Real(rise / t.h)); };
    const auto end = [&] {
      return typename LinearPiece<Real>::End{PieceEvent::none, t.h, {next_y, next_v, next_a}};
    };
    if constexpr (Run::AnyWatcher::watches) {
      if (passes || next_y < arrival) {
        run.watcher().piece(samples.times().at(i), s.direction, piece());
      }
    }
    if (next_y >= arrival) [[unlikely]] {
      if (!passes) {
        break;
      }
      arrival = std::numeric_limits<Real>::max();
      s.now = samples.times().at(i);
      run.cross(piece(), end(), crossing);
    }
    if (Run::magnitude(next_a) > matters) [[unlikely]] {
      largest = piece().largest_acceleration(end(), largest);
      matters = threshold(next_a);
    }
    y = next_y;
    v = next_v;
    a = next_a;
    w = next_w;
  }
  s.acceleration = largest;
  s.u = sign * y;
  s.v = sign * v;
  return i;
}

}  // namespace stillpoint
