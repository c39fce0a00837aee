// SPDX-License-Identifier: MIT
#pragma once

// The paper's friction as a forced run asks for it: f everywhere, and at x = 0 a notch that holds
// for ever or, docs/notches.md rule 1, holds a load of h besides. In the units of forced_run.hpp;
// y is the place in the direction of the motion.

#include "kernel/hold.hpp"

#include <stillpoint/core/oscillator.hpp>
#include <stillpoint/core/state.hpp>

#include <limits>

namespace stillpoint {

template <class Real>
class ConstantFriction {
 public:
  static constexpr bool in_zones = false;
  static constexpr bool damped = false;

  explicit ConstantFriction(const BasicOscillator<Real>& oscillator)
      : p_(oscillator.p),
        f_(oscillator.f),
        phi_(oscillator.f / oscillator.p),
        notched_(oscillator.delta > 0),
        lets_go_(notched_ && oscillator.hold),
        h_(lets_go_ ? *oscillator.hold : Real(0)),
        spare_(h_ / oscillator.p) {}

  /// Friction from y on.
  [[nodiscard]] const Real& phi_ahead(const Real& /*y*/) const { return phi_; }

  /// Where the notch takes its part: x = 0, or never.
  [[nodiscard]] Real edge_ahead(const Real& y) const {
    return notched_ && y < 0 ? Real(0) : std::numeric_limits<Real>::max();
  }

  /// The load that a rest at u can hold in the direction `sign`.
  [[nodiscard]] Real capacity(const Real& u, int /*sign*/) const {
    return at_notch(u) ? Real(phi_ + spare_) : phi_;
  }

  [[nodiscard]] Hold<Real> hold_at(const Real& u) const {
    if (at_notch(u)) {
      return {p_, f_, phi_, u, h_, spare_};
    }
    return {p_, f_, phi_, u};
  }

  /// Whether the notch lets go at some load, so that no rest there is final while the load goes on.
  [[nodiscard]] bool lets_go() const { return lets_go_; }
  [[nodiscard]] bool at_notch(const Real& u) const { return lets_go_ && u == 0; }
  /// The load that it holds besides friction, h / p.
  [[nodiscard]] const Real& spare() const { return spare_; }

  /// How far a position |u| is from where the law changes.
  [[nodiscard]] const Real& from_edge(const Real& distance) const { return distance; }

  /// The mass has come to rest.
  void rest() {}

  /// The largest load that a rest at u holds.
  [[nodiscard]] Real most_held(const Real& u) const { return capacity(u, 1); }

  /// Whether it is the notch that holds a mass at rest; it holds one that never moved only where it
  /// lets go: rule 4 of docs/forced.md.
  [[nodiscard]] bool notch_holds(const Real& u, bool came_there) const {
    return notched_ && u == 0 && (came_there || lets_go_);
  }

  [[nodiscard]] Outcome rest_at(const Real& u) const {
    return u == 0 ? Outcome::stopped_at_zero : Outcome::stopped_in_dead_zone;
  }

 private:
  Real p_;
  Real f_;
  Real phi_;
  bool notched_;
  bool lets_go_;
  Real h_;
  Real spare_;
};

}  // namespace stillpoint
