// SPDX-License-Identifier: MIT
#pragma once

// v only touches 0, and the mass goes on: docs/forced.md rule 5 and (F33). Symbols as in
// forced_run.hpp.

#include "kernel/exact_sum.hpp"

namespace stillpoint {

/// `left` is the time that the drive still has. Under it load, spring and friction cancel here, or
/// rounding errors of u would add up from one touch to the next.
template <class Run, class Drive, class Real>
void touch(Run& run, const Drive& drive, const ExactSum<Real>& left) {
  auto& s = run.state();
  s.margin.decide(Real(0), Real(1));
  if (left.value() > 0) {
    const Real sign(s.direction);
    const Real w = drive.load().full.value() / run.map().p;
    const Real place = -(w + sign * run.law().phi_ahead(Real(sign * s.u)));
    if (place * s.u > 0) {  // never beyond x = 0
      s.u = place;
    }
    s.first_acceleration = Real(0);
  }
}

}  // namespace stillpoint
