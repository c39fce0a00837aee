// SPDX-License-Identifier: MIT
#pragma once

// Decisions of a forced run that depend on where a load jumps, ends or only just holds the mass:
// docs/forced.md section 7. Symbols as in forced_run.hpp.

#include "kernel/forced_state.hpp"
#include "kernel/functions.hpp"
#include "kernel/hold.hpp"

#include <algorithm>

namespace stillpoint {

/// Is the mass held?
template <class Run, class Real>
void decide_hold(Run& run, const Load<Real>& load) {
  const Real& u = run.state().u;
  const auto hold = run.law().hold_at(u);
  const Real excess = magnitude(Real(u + load.w)) - hold.phi(hold.sign(load));
  run.state().margin.decide(magnitude(excess), hold.size(load.w));
}

/// Does the last turn, or the next under this load, come before this instant or after it? By its
/// distance in time to first order, of the time so far.
template <class Run, class Real>
void decide_turn_at(Run& run, const Load<Real>& load) {
  ForcedState<Real>& s = run.state();
  const Real now = s.now.value();
  if (s.mode == ForcedMode::resting) {
    s.margin.decide(s.now.minus(s.rest_begin), now);
    return;
  }
  const Real v = magnitude(s.v);
  s.margin.decide(v, v + magnitude(run.own_direction(load.w).a) * now);
}

/// Would a mass that arrives at x = 0 have turned before it if the load had changed first, as it
/// does after the time `left`? docs/forced.md (F35).
template <class Run, class Real>
void decide_arrival_before_change(Run& run, const Real& w, const Real& left) {
  ForcedState<Real>& s = run.state();
  const Real v = magnitude(s.v);
  if (v == 0) {
    return;  // no arrival has a smaller margin
  }
  const Real slid = std::min(Real(s.now.value() - s.slide_begin), Real(2));
  const Real force = run.law().phi_ahead(Real(0)) + magnitude(w);
  const Real pushed = force * slid;
  s.margin.decide(v, v + pushed * (pushed / (2 * force * left + v)));
}

/// W jumps here: docs/forced.md (F26).
template <class Run, class Real>
[[gnu::noinline]] void decide_jump(Run& run, const Load<Real>& from, const Load<Real>& to) {
  if (run.over()) {
    return;
  }
  const auto hold = run.law().hold_at(run.state().u);
  const int driven = hold.drives(to);
  if (run.state().mode == ForcedMode::resting) {
    decide_hold(run, to);
    if (driven != -hold.sign(from)) {
      decide_hold(run, from);  // against a release just before
    }
  }
  if (driven != hold.drives(from)) {
    decide_turn_at(run, from);
  }
}

/// The run ends here, before the motion does: (F26) again, for passages too, and whether it is at
/// rest at x = 0, where rounding alone gives it a side.
template <class Run, class Real>
void decide_end(Run& run, const Load<Real>& load) {
  if (run.over()) {
    return;
  }
  decide_turn_at(run, load);
  ForcedState<Real>& s = run.state();
  if (s.mode == ForcedMode::resting) {
    decide_hold(run, load);
  } else {
    const Real distance = magnitude(s.u);
    const Real v = magnitude(s.v);
    s.margin.decide(distance, distance + v * s.now.value());
    const Real radius = std::max(distance, v);
    s.margin.decide(radius, radius + s.farthest);
  }
}

}  // namespace stillpoint
