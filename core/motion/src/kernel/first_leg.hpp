// SPDX-License-Identifier: MIT
#pragma once

// From any start to the first peak, the first arrival at x = 0, or rest: docs/theory.md section 4.
// Speeds throughout, as in half_cycle_map.hpp; distance = p |x0|, speed = |v0|.

#include "kernel/functions.hpp"
#include "kernel/half_cycle_map.hpp"

#include <algorithm>
#include <cmath>

namespace stillpoint {

enum class FirstLegEnd {
  no_motion,  ///< at rest where it started
  caught,     ///< held by the notch at x = 0, rule 4
  peak,       ///< moved away from x = 0, up to a peak
  arrival,    ///< moved towards x = 0 and reached it
  rest,       ///< moved towards x = 0 and came to rest before it
};

template <class Real>
struct FirstLeg {
  FirstLegEnd end{FirstLegEnd::no_motion};
  int side{1};           ///< sign of x on this leg
  Real distance{0};      ///< p |x0|
  Real speed{0};         ///< |v0|
  Real radius{0};        ///< of the leg's arc
  Real farthest{0};      ///< largest p |x| on the leg; for `peak` the peak
  Real energy{0};        ///< for `arrival`: v^2 at x = 0; for `peak`: v^2 at x = 0 on the same arc
  Real rest{0};          ///< for `no_motion` and `rest`: p |x| where it rests, else 0
  Real acceleration{0};  ///< largest |x''| / p on the leg
};

/// sqrt(a^2 + b^2). Valid speeds are at most 1e150 (oscillator.hpp): no square overflows.
template <class Real>
Real hypotenuse(const Real& a, const Real& b) {
  using std::sqrt;
  return sqrt(a * a + b * b);
}

namespace detail {

template <class Real>
FirstLeg<Real> outward_leg(const HalfCycleMap<Real>& map, int side, const Real& distance,
                           const Real& speed) {
  const Real lever = distance + map.phi;
  const Real radius = hypotenuse(speed, lever);                     // (10)
  const Real peak = distance + speed * (speed / (radius + lever));  // (11)
  const Real energy = distance * (distance + 2 * map.phi) + speed * speed;
  return {FirstLegEnd::peak, side, distance, speed, radius, peak, energy, Real(0), radius};
}

template <class Real>
FirstLeg<Real> inward_leg(const HalfCycleMap<Real>& map, int side, const Real& distance,
                          const Real& speed) {
  using std::max;
  const Real lever = magnitude(Real(distance - map.phi));
  const Real radius = hypotenuse(speed, lever);
  const Real arrival = distance * (distance - 2 * map.phi) + speed * speed;  // (12)
  if (arrival < 0) {
    const Real rest = -arrival / (radius + map.phi);  // (13)
    return {FirstLegEnd::rest, side, distance, speed, radius, distance, Real(0), rest, radius};
  }
  return {FirstLegEnd::arrival, side, distance, speed, radius, distance, arrival, Real(0),
          max(lever, map.phi)};
}

}  // namespace detail

/// Rules 2 and 4 of docs/theory.md at the start, then the first arc.
template <class Real>
FirstLeg<Real> first_leg(const HalfCycleMap<Real>& map, const BasicStart<Real>& start) {
  const Real distance = map.p * magnitude(start.x0);
  const Real speed = magnitude(start.v0);
  const int side = start.x0 != 0 ? (start.x0 > 0 ? 1 : -1) : (start.v0 < 0 ? -1 : 1);
  const bool at_zero = distance == 0;
  if (speed == 0 && distance <= map.phi) {
    FirstLeg<Real> still{FirstLegEnd::no_motion, side, distance, speed};
    still.farthest = still.rest = distance;
    return still;
  }
  if (at_zero && map.catches(speed)) {
    return {FirstLegEnd::caught, side, distance, speed};
  }
  const bool outward = at_zero || (start.v0 > 0) == (start.x0 > 0);
  return outward && speed != 0 ? detail::outward_leg(map, side, distance, speed)
                               : detail::inward_leg(map, side, distance, speed);
}

}  // namespace stillpoint
