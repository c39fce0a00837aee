// SPDX-License-Identifier: MIT
#pragma once

// Watches a free run and keeps the decision margin, docs/theory.md section 6: the smallest relative
// change of all inputs (x0, v0, p, f, Delta) at once, each in its worst direction, that changes a
// decision of the run, to first order. A run whose margin is far above the rounding errors has
// the counts and the outcome of the exact motion.
//
// Every decision is the sign of some g(inputs); its margin is |g| / sum |input dg/dinput|. As
// speeds v0 and sqrt(notch) carry one input, phi and the distance two each (docs/theory.md (19) to
// (22)). `spread(q)` below stands for the sum over the inputs of |input dq/dinput|, or a bound of
// it.

#include "kernel/first_leg.hpp"
#include "kernel/functions.hpp"
#include "kernel/half_cycle_map.hpp"

#include <cmath>
#include <optional>

namespace stillpoint {

template <class Real>
class MarginKeeper {
 public:
  /// None if nothing was decided: a motion without friction, or no motion.
  [[nodiscard]] const std::optional<Real>& margin() const { return margin_; }

  void first_leg(const HalfCycleMap<Real>& map, const FirstLeg<Real>& leg) {
    const Real& x = leg.distance;
    const Real& v = leg.speed;
    const Real& phi = map.phi;
    if (v == 0 && x != 0 && phi > 0) {
      decide(x - phi, 2 * x + 2 * phi);
    }
    if (x == 0 && v != 0 && map.notch > 0) {
      decide(v * v - map.notch, 2 * v * v + map.notch);
    }
    if (leg.end == FirstLegEnd::peak) {
      const Real lever = x + phi;
      spread_radius_ = (2 * lever * lever + v * v) / leg.radius;
      spread_square_ = 2 * leg.radius * spread_radius_;
    } else if (leg.end == FirstLegEnd::arrival || leg.end == FirstLegEnd::rest) {
      const Real g = x * (x - 2 * phi) + v * v;
      spread_arrival_ = 4 * x * magnitude(Real(x - phi)) + 4 * x * phi + 2 * v * v;
      spread_square_ = 4 * magnitude(Real(x - phi)) * (x + phi) + 2 * v * v;
      if (phi > 0) {
        decide(g, spread_arrival_);
      }
    }
  }

  void first_passage(const HalfCycleMap<Real>& map, const Real& /*energy*/, const Real& radius) {
    spread_radius_ = (spread_square_ + map.notch) / (2 * radius);
    spread_square_ += map.notch;
  }

  /// Does the motion return, and if not, does it swing back?
  void crest(const HalfCycleMap<Real>& map, const Real& radius) {
    const Real& phi = map.phi;
    decide(radius - 3 * phi, spread_radius_ + 6 * phi);
    if (!map.returns(radius)) {
      decide(radius - 2 * phi, spread_radius_ + 4 * phi);
      return;
    }
    const Real t = radius - 2 * phi;
    spread_square_ = 2 * t * (spread_radius_ + 4 * phi);
    spread_arrival_ = spread_square_ + 4 * phi * phi;
  }

  /// Does it pass?
  void arrival(const HalfCycleMap<Real>& map, const Real& arrival) {
    decide(map.departure(arrival), spread_arrival_ + map.notch);
  }

  void passage(const HalfCycleMap<Real>& map, const Real& /*arrival*/, const Real& /*energy*/,
               const Real& radius) {
    spread_radius_ = (spread_square_ + map.notch) / (2 * radius);
  }

  /// The last return and the first failure to return are the nearest decisions of (17).
  void constant_friction(const HalfCycleMap<Real>& map, const Real& passages, const Real& last) {
    const Real& phi = map.phi;
    const Real spread = spread_radius_ + 4 * phi * passages;
    if (passages > 0) {
      decide(last, spread + 2 * phi);
    }
    decide(last - 2 * phi, spread + 6 * phi);
    decide(last - phi, spread + 4 * phi);
  }

  /// The last passage and the first failure to pass are the nearest decisions of (18).
  void point_friction(const HalfCycleMap<Real>& map, const Real& passages, const Real& last) {
    const Real& spread = spread_square_;
    if (passages > 0) {
      decide(last, spread + passages * map.notch);
    }
    decide(map.notch - last, spread + (passages + 1) * map.notch);
  }

  void stops_at_zero(const HalfCycleMap<Real>& /*map*/, const Real& /*passages*/,
                     const Real& /*arrival*/) {}
  void stops_in_dead_zone(const Real& /*passages*/, bool /*swings_back*/) {}

 private:
  void decide(const Real& g, const Real& spread) {
    const Real distance = magnitude(g) / spread;
    if (!margin_ || distance < *margin_) {
      margin_ = distance;
    }
  }

  std::optional<Real> margin_;
  Real spread_radius_{0};
  Real spread_arrival_{0};
  Real spread_square_{0};  ///< of arrival + phi^2, or of the first radius squared
};

}  // namespace stillpoint
