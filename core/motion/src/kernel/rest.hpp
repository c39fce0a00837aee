// SPDX-License-Identifier: MIT
#pragma once

// The mass at rest under a load, and how it begins to move: rule 2 of docs/forced.md section 1.
// Symbols as in forced_run.hpp.

#include "kernel/exact_sum.hpp"
#include "kernel/forced_state.hpp"
#include "kernel/functions.hpp"
#include "kernel/hold.hpp"
#include "kernel/transmitted.hpp"

#include <stillpoint/core/state.hpp>

#include <algorithm>
#include <optional>

namespace stillpoint {

/// What the notch held is free now; only here a passage takes time.
template <class Run, class Real>
void leave_notch(Run& run, ForcedState<Real>& s) {
  *s.first_acceleration += run.law().spare();
  if (s.moved) {
    run.pass();
    run.event(EventKind::passage);
  }
}

template <class Run, class Real>
void set_off(Run& run, int direction, const Real& acceleration) {
  ForcedState<Real>& s = run.state();
  const Real waited = s.fresh ? Real(0) : s.now.minus(s.rest_begin);
  s.mode = ForcedMode::sliding;
  s.slide_begin = s.now.value();
  s.direction = direction;
  if (!s.moved) {
    slides(s, run.law());
  }
  if (waited > 0) {
    ++s.sticks;
    s.stuck.add(waited);
    is_held(s, run.law(), s.now, false);
    s.transmitted.locked = Real(0);
    run.event(EventKind::release);
  }
  s.first_acceleration = acceleration;
  if constexpr (Run::AnyLaw::in_zones) {
    *s.first_acceleration += run.law().lost_ahead(Real(direction) * s.u);
  }
  s.fresh = false;
  const bool let_go = run.law().at_notch(s.u);
  s.left_notch_from_rest = s.left_notch_from_rest || (s.u == 0 && run.map().notch > 0 && !let_go);
  if (let_go) {
    leave_notch(run, s);
  }
  s.moved = true;
}

/// Under a drive that has the time `left`; `for_ever`: no other drive follows.
template <class Run, class Drive, class Real>
void rest(Run& run, Drive& drive, ExactSum<Real>& left, bool for_ever) {
  ForcedState<Real>& s = run.state();
  const auto hold = run.law().hold_at(s.u);
  const Real w = drive.w();
  const Real load = s.u + w;
  const int sign = load > 0 ? 1 : -1;
  const Real phi = hold.phi(sign);
  const Real size = magnitude(s.u) + magnitude(w) + phi;
  Real excess = hold.beyond(magnitude(load), sign);
  if (s.fresh) {
    s.margin.decide(magnitude(excess), std::max(size, Real(drive.amplitude())));
  }
  if (Hold<Real>::may_tie(excess, size)) {
    excess = hold.excess(drive.load(), sign);
  }
  if (excess > 0) {
    set_off(run, -sign, excess);
    return;
  }
  if (s.fresh) {
    s.fresh = false;
    run.event(EventKind::stick);
  }
  if (for_ever) {
    const Real largest = drive.largest_load(s.u);
    s.margin.decide(magnitude(Real(largest - phi)), largest + phi);
    if (!(drive.largest_excess(hold) > 0)) {
      run.stop_where_it_rests();
      return;
    }
  }
  const std::optional<ExactSum<Real>> wait = drive.release(hold);
  const bool waits = !wait || !(wait->value() < left.value());
  drive.crests(hold, waits ? left.value() : wait->value(), !waits);
  if (waits) {
    s.now.add(left.high());
    s.now.add(left.low());
    drive.advance(left.value());
    left = ExactSum<Real>();
    return;
  }
  left.add(-wait->high(), -wait->low());
  s.now.add(wait->high(), wait->low());
  drive.advance(*wait);
  set_off(run, drive.release_direction(), Real(0));
}

}  // namespace stillpoint
