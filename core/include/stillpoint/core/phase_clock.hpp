// SPDX-License-Identifier: MIT
#pragma once

// Watches a free run and adds up its duration as a phase, p * tau: docs/theory.md section 5.
// From peak to peak it is pi less a small deficit, so nothing large is ever subtracted; the deficit
// is exactly 0 where either friction is.

#include <stillpoint/core/first_leg.hpp>
#include <stillpoint/core/half_cycle_map.hpp>

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

/// (14): the phase of the first leg.
template <class Real>
Real first_leg_phase(const HalfCycleMap<Real>& map, const FirstLeg<Real>& leg) {
  using std::atan2;
  using std::sqrt;
  const Real& phi = map.phi;
  const Real& x = leg.distance;
  const Real& v = leg.speed;
  switch (leg.end) {
    case FirstLegEnd::peak:
      return atan2(v, Real(x + phi));
    case FirstLegEnd::rest:
      return atan2(v, Real(phi - x));
    case FirstLegEnd::arrival: {
      const Real w = sqrt(leg.energy);
      if (v == 0) {  // a swing from rest, and w may be 0 as well
        return pi<Real>() / 2 + atan2(phi, w);
      }
      const Real cross = x * ((w * v + v * v + (x - phi) * (x - 2 * phi)) / (w + v));
      return atan2(cross, Real(v * w - (x - phi) * phi));
    }
    case FirstLegEnd::no_motion:
    case FirstLegEnd::caught:
      break;
  }
  return Real(0);
}

template <class Real>
class PhaseClock {
 public:
  /// p * tau at the end of the motion.
  [[nodiscard]] Real phase() const { return pi<Real>() * half_turns_ + (outer_phase_ - deficit_); }

  void first_leg(const HalfCycleMap<Real>& map, const FirstLeg<Real>& leg) {
    outer_phase_ = first_leg_phase(map, leg);
  }

  void first_passage(const HalfCycleMap<Real>& map, const Real& energy, const Real& /*radius*/) {
    outer_phase_ += up(map, energy);
  }

  void crest(const HalfCycleMap<Real>& /*map*/, const Real& /*radius*/) {}
  void arrival(const HalfCycleMap<Real>& /*map*/, const Real& /*arrival*/) {}

  /// (15): pi - atan2(phi d / (w + v), w v + phi^2) from one peak to the next.
  void passage(const HalfCycleMap<Real>& map, const Real& arrival, const Real& energy,
               const Real& /*radius*/) {
    using std::atan2;
    using std::sqrt;
    const Real w = sqrt(arrival);
    const Real v = sqrt(energy);
    deficit_ += atan2(Real(map.phi * (map.notch / (w + v))), Real(w * v + map.phi * map.phi));
  }

  void constant_friction(const HalfCycleMap<Real>& /*map*/, const Real& /*passages*/,
                         const Real& /*last*/) {}
  void point_friction(const HalfCycleMap<Real>& /*map*/, const Real& /*passages*/,
                      const Real& /*last*/) {}

  void stops_at_zero(const HalfCycleMap<Real>& map, const Real& passages, const Real& arrival) {
    half_turns_ += passages;
    outer_phase_ += down(map, arrival);
  }

  void stops_in_dead_zone(const Real& passages, bool swings_back) {
    half_turns_ += passages + (swings_back ? 1 : 0);
  }

  /// From x = 0 up to the peak.
  static Real up(const HalfCycleMap<Real>& map, const Real& energy) {
    using std::atan2;
    using std::sqrt;
    return atan2(Real(sqrt(energy)), map.phi);
  }

  /// From the peak down to x = 0.
  static Real down(const HalfCycleMap<Real>& map, const Real& arrival) {
    using std::atan2;
    using std::sqrt;
    return pi<Real>() / 2 + atan2(map.phi, Real(sqrt(arrival)));
  }

 private:
  Real half_turns_{0};
  Real outer_phase_{0};  ///< before the first and after the last peak
  Real deficit_{0};
};

}  // namespace stillpoint
