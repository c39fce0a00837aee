// SPDX-License-Identifier: MIT
#pragma once

// Watches a free run and adds up its duration as a phase, p * tau: docs/theory.md section 5.
// From peak to peak it is pi less a small deficit, so nothing large is ever subtracted; the deficit
// is exactly 0 where either friction is. All angles are added as a product, with one arctangent at
// the end.

#include "kernel/first_leg.hpp"
#include "kernel/functions.hpp"
#include "kernel/half_cycle_map.hpp"
#include "kernel/rotor.hpp"

#include <cmath>
#include <numbers>
#include <type_traits>

namespace stillpoint {

template <class Real>
Real pi() {
  if constexpr (std::is_floating_point_v<Real>) {
    return std::numbers::pi_v<Real>;
  } else {
    static const Real value = acos(Real(-1));
    return value;
  }
}

/// An angle in [0, pi], as a point in its direction.
template <class Real>
struct Direction {
  Real cosine{1};
  Real sine{0};
};

/// (14): the phase of the first leg.
template <class Real>
Direction<Real> first_leg_direction(const HalfCycleMap<Real>& map, const FirstLeg<Real>& leg) {
  using std::sqrt;
  const Real& phi = map.phi;
  const Real& x = leg.distance;
  const Real& v = leg.speed;
  switch (leg.end) {
    case FirstLegEnd::peak:
      return {Real(x + phi), v};
    case FirstLegEnd::rest:
      return {Real(phi - x), v};
    case FirstLegEnd::arrival: {
      const Real w = sqrt(leg.energy);
      if (v == 0) {  // a swing from rest, and w may be 0 as well
        return {Real(-phi), w};
      }
      const Real cross = x * ((w * v + v * v + (x - phi) * (x - 2 * phi)) / (w + v));
      return {Real(v * w - (x - phi) * phi), cross};
    }
    case FirstLegEnd::no_motion:
    case FirstLegEnd::caught:
      break;
  }
  return {};
}

template <class Real>
Real first_leg_phase(const HalfCycleMap<Real>& map, const FirstLeg<Real>& leg) {
  const Direction<Real> direction = first_leg_direction(map, leg);
  return elementary::atan2(direction.sine, direction.cosine);
}

template <class Real>
class PhaseClock {
 public:
  /// p * tau at the end of the motion.
  [[nodiscard]] Real phase() const {
    const Real quarters = outer_.quarters - deficit_.quarters;
    return pi<Real>() * half_turns_ + (pi<Real>() / 2 * quarters + angle_between(outer_, deficit_));
  }

  void first_leg(const HalfCycleMap<Real>& map, const FirstLeg<Real>& leg) {
    const Direction<Real> direction = first_leg_direction(map, leg);
    if (direction.cosine < 0) {
      outer_.quarters += 1;
      outer_.turn(direction.sine, Real(-direction.cosine));
    } else {
      outer_.turn(direction.cosine, direction.sine);
    }
    if (leg.radius != 0) {
      scale_ = unit_scale(leg.radius);
    }
  }

  void first_passage(const HalfCycleMap<Real>& map, const Real& energy, const Real& /*radius*/) {
    using std::sqrt;
    outer_.turn(map.phi, Real(sqrt(energy)));
  }

  void crest(const HalfCycleMap<Real>& /*map*/, const Real& /*radius*/) {}
  void arrival(const HalfCycleMap<Real>& /*map*/, const Real& /*arrival*/) {}

  /// (15): a half turn minus the angle of (w v + phi^2)(w + v) + i phi d from one peak to the next.
  void passage(const HalfCycleMap<Real>& map, const Real& arrival, const Real& energy,
               const Real& /*radius*/) {
    using std::sqrt;
    const Real w = sqrt(arrival) * scale_;
    const Real v = sqrt(energy) * scale_;
    const Real phi = map.phi * scale_;
    const Real notch = map.notch * scale_ * scale_;
    deficit_.turn(Real((w * v + phi * phi) * (w + v)), Real(phi * notch));
  }

  void constant_friction(const HalfCycleMap<Real>& /*map*/, const Real& /*passages*/,
                         const Real& /*last*/) {}
  void point_friction(const HalfCycleMap<Real>& /*map*/, const Real& /*passages*/,
                      const Real& /*last*/) {}

  void stops_at_zero(const HalfCycleMap<Real>& map, const Real& passages, const Real& arrival) {
    using std::sqrt;
    half_turns_ += passages;
    outer_.quarters += 1;
    outer_.turn(Real(sqrt(arrival)), map.phi);
  }

  void stops_in_dead_zone(const Real& passages, bool swings_back) {
    half_turns_ += passages + (swings_back ? 1 : 0);
  }

  /// From x = 0 up to the peak.
  static Real up(const HalfCycleMap<Real>& map, const Real& energy) {
    using std::sqrt;
    return elementary::atan2(Real(sqrt(energy)), map.phi);
  }

  /// From the peak down to x = 0.
  static Real down(const HalfCycleMap<Real>& map, const Real& arrival) {
    using std::sqrt;
    return pi<Real>() / 2 + elementary::atan2(map.phi, Real(sqrt(arrival)));
  }

 private:
  Real half_turns_{0};
  Rotor<Real> outer_;    ///< before the first and after the last peak
  Rotor<Real> deficit_;  ///< of the half-cycles between them
  Real scale_{1};        ///< brings the first radius to about 1: no product of speeds overflows
};

}  // namespace stillpoint
