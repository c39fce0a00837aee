// SPDX-License-Identifier: MIT
#pragma once

// Takes a forced run through each kind of excitation, one overload per kind.

#include "kernel/drive_phase.hpp"
#include "kernel/drives.hpp"
#include "kernel/exact_sum.hpp"
#include "kernel/excitation_law.hpp"
#include "kernel/forced_run.hpp"
#include "kernel/record_run.hpp"

#include <stillpoint/core/excitation.hpp>

#include <limits>

namespace stillpoint {

namespace detail {

/// k sin psi and, beside it, a constant load; that at its end.
template <class Real, class Watcher, class Law>
Load<Real> harmonic(ForcedRun<Real, Watcher, Law>& run, const Real& k, DrivePhase<Real> psi,
                    const Real& beside, const ExactSum<Real>& length, bool for_ever) {
  const Real& p = run.map().p;
  const Real size = k / p;
  // sin(psi + pi) in place of a negative k
  if (size < 0) {
    psi.turn_by(Real(0.5));
  }
  const Load<Real> crest =
      size < 0 ? Load<Real>{-size, ExactSum<Real>(-k)} : Load<Real>{size, ExactSum<Real>(k)};
  HarmonicDrive<Real> drive(psi, crest, {beside / p, ExactSum<Real>(beside)}, run.state().margin);
  run.through(drive, length, for_ever);
  return drive.load();
}

}  // namespace detail

/// Through the excitation, or until p tau = `end` if that is earlier; returns the load there.
template <class Real, class Watcher, class Law>
Load<Real> excite(ForcedRun<Real, Watcher, Law>& /*run*/, const NoExcitation& /*excitation*/,
                  const ExactSum<Real>& /*end*/) {
  return {};
}

template <class Real, class Watcher, class Law, IsSine Sine>
Load<Real> excite(ForcedRun<Real, Watcher, Law>& run, const Sine& sine, const ExactSum<Real>& end) {
  const Real& p = run.map().p;
  const Real lasts = duration_of<Real>(sine);
  const ExactSum<Real> length = detail::earlier(p, lasts, end);
  if constexpr (IsSquare<Sine>) {  // (F39)
    DrivePhase<Real> psi(2 * sine.lambda, p, Real(0));
    psi.turn_by(Real(-0.25));
    const Real half = sine.k / 2;
    return detail::harmonic(run, half, psi, half, length, false);
  } else {
    return detail::harmonic(run, sine.k, {sine.lambda, p, Real(sine.phase)}, Real(0), length,
                            lasts == std::numeric_limits<Real>::infinity());
  }
}

template <class Real, class Watcher, class Law>
Load<Real> excite(ForcedRun<Real, Watcher, Law>& run, const BasicRecord<Real>& record,
                  const ExactSum<Real>& end) {
  return RecordRun<Real, Watcher, Law>(run, record).through(end);
}

template <class Real, class Watcher, class Law, IsPolygon Polygon>
Load<Real> excite(ForcedRun<Real, Watcher, Law>& run, const Polygon& pulse,
                  const ExactSum<Real>& end) {
  const Real lasts = duration_of<Real>(pulse);
  if constexpr (Polygon::corners.size() > 2) {
    return excite(run, record_of(pulse, lasts), end);
  } else {
    const Real& p = run.map().p;
    const Real first = Real(Polygon::corners.front().load) * pulse.k;
    const Real last = Real(Polygon::corners.back().load) * pulse.k;
    LinearDrive<Real> drive(Real(first / p), first, Real(last / p), last, Real(p * lasts));
    run.through(drive, detail::earlier(p, lasts, end), false);
    return drive.load();
  }
}

/// The load there.
template <class Real, class Watcher, class Law, class AnyExcitation>
Load<Real> excite_whole(ForcedRun<Real, Watcher, Law>& run, const AnyExcitation& excitation) {
  return excite(run, excitation,
                ExactSum<Real>::product(run.map().p, duration_of<Real>(excitation)));
}

/// The motion after an excitation that ended with `load`, up to p tau = `end`.
template <class Real, class Watcher, class Law>
void free_until(ForcedRun<Real, Watcher, Law>& run, const Load<Real>& load,
                const ExactSum<Real>& end) {
  if (run.over()) {
    return;
  }
  LinearDrive<Real> nothing;
  decide_jump(run, load, nothing.load());
  run.event(EventKind::excitation_end);
  run.settle();
  ExactSum<Real> left = end;
  left.add(-run.state().now.high());
  left.add(-run.state().now.low());
  run.through(nothing, left, true);
  decide_end(run, nothing.load());
}

/// The whole motion up to tau = t_end.
template <class Real, class Watcher, class Law, class AnyExcitation>
void run_until(ForcedRun<Real, Watcher, Law>& run, const AnyExcitation& excitation,
               const Real& t_end) {
  if (run.over()) {
    return;
  }
  const ExactSum<Real> end = ExactSum<Real>::product(run.map().p, t_end);
  const Load<Real> load = excite(run, excitation, end);
  if (t_end < duration_of<Real>(excitation)) {
    decide_end(run, load);
  } else {
    free_until(run, load, end);
  }
}

/// The motion after an excitation that ended with `load`, up to the next turn or to its rest; in
/// zones always to its rest, if there is one.
template <class Real, class Watcher, class Law>
[[gnu::noinline]] void to_free_turn(ForcedRun<Real, Watcher, Law>& run, const Load<Real>& load) {
  if (run.over()) {
    return;
  }
  LinearDrive<Real> nothing;
  decide_jump(run, load, nothing.load());
  run.event(EventKind::excitation_end);
  if constexpr (Law::in_zones) {
    slide_to_rest(run, nothing);  // there is no half-cycle map for zones
  } else {
    run.slide_to_turn(nothing);
    run.settle();
  }
}

/// The same from the start.
template <class Real, class Watcher, class Law, class AnyExcitation>
void run_to_free_turn(ForcedRun<Real, Watcher, Law>& run, const AnyExcitation& excitation) {
  if (!run.over()) {
    to_free_turn(run, excite_whole(run, excitation));
  }
}

}  // namespace stillpoint
