// SPDX-License-Identifier: MIT
#pragma once

// What the structure feels, docs/forced.md section 10: |f + p^2 y| while the mass slides towards
// growing y, |W| while it is held. Units and symbols as in forced_run.hpp, but loads are W itself.

#include "kernel/exact_sum.hpp"
#include "kernel/functions.hpp"

#include <algorithm>
#include <functional>

namespace stillpoint {

/// The largest transmitted acceleration of a run so far.
template <class Real>
struct Transmitted {
  Real slid{0};    ///< while it slid, over p
  Real held{0};    ///< while it was held, where that may be more than it felt before: (F29)
  Real locked{0};  ///< while the notch holds it to the end of the run; 0 if no load follows
  /// The largest |W| from one p tau to another; empty if these metrics are not needed.
  std::function<Real(const ExactSum<Real>&, const ExactSum<Real>&)> largest_load;

  /// (F28): at both ends of a slide. y is the place in its direction.
  void slides(const Real& y, const Real& phi) {
    using std::max;
    slid = max(slid, magnitude(Real(y + phi)));
  }
};

template <class Real>
struct ForcedState;

/// (F28): here.
template <class Real, class Law>
void slides(ForcedState<Real>& s, const Law& law) {
  const Real y = Real(s.direction) * s.u;
  if constexpr (Law::damped) {
    s.transmitted.slides(y, Real(law.phi_ahead(y) + law.drag(magnitude(s.v))));
  } else {
    s.transmitted.slides(y, law.phi_ahead(y));
  }
}

/// (F29): from rest_begin until `end`; `stays`: the run ends there.
template <class Real, class Law>
void is_held(ForcedState<Real>& s, const Law& law, const ExactSum<Real>& end, bool stays) {
  using std::max;
  const bool locks = stays && law.notch_holds(s.u, s.moved || s.caught);
  const bool may_count = locks || Real(magnitude(s.u) + law.most_held(s.u)) > s.transmitted.slid;
  if (may_count && s.transmitted.largest_load) {
    const Real load = s.transmitted.largest_load(s.rest_begin, end);
    s.transmitted.held = max(s.transmitted.held, load);
    s.transmitted.locked = locks ? load : Real(0);
  }
}

/// At the end of the run; a mass that rests for ever stays there up to `end`.
template <class Real, class Law>
void feel_the_end(ForcedState<Real>& s, const Law& law, const ExactSum<Real>& end) {
  if (s.v != 0) {
    slides(s, law);
  } else {
    is_held(s, law, s.outcome ? end : s.now, true);
  }
}

}  // namespace stillpoint
