// SPDX-License-Identifier: MIT
#pragma once

// Friction that steps with |x|, and a notch of finite width as a step of its own: docs/notches.md.
// What a forced run requires of a law is as in constant_friction.hpp. In the units of
// forced_run.hpp; the zones between the edges 0 = e_0 < e_1 < ... have the frictions phi_0, phi_1,
// ..., the last one without end. y is the place in the direction of the motion, so that a zone is
// entered at -e_(i+1) or e_i.

#include "kernel/functions.hpp"
#include "kernel/hold.hpp"

#include <stillpoint/core/oscillator.hpp>
#include <stillpoint/core/state.hpp>
#include <stillpoint/core/surface.hpp>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <utility>
#include <vector>

namespace stillpoint {

/// At an edge each side has its own friction, so each direction of the load has: rule 4.
template <class Real>
class EdgeHold {
 public:
  static constexpr bool symmetric = false;

  /// `one_sided` makes that for loads that drive the mass towards smaller u, and towards greater;
  /// each in its place, for they are long and are made at every event.
  template <class OneSided>
  explicit EdgeHold(const OneSided& one_sided) : below_(one_sided(1)), above_(one_sided(-1)) {}

  [[nodiscard]] const Real& u() const { return below_.u(); }
  [[nodiscard]] const Hold<Real>& toward(int sign) const { return sign > 0 ? below_ : above_; }
  [[nodiscard]] const Real& phi(int sign) const { return toward(sign).phi(sign); }
  [[nodiscard]] Real beyond(const Real& load, int sign) const {
    return toward(sign).beyond(load, sign);
  }
  [[nodiscard]] int sign(const Load<Real>& load) const { return below_.sign(load); }
  [[nodiscard]] Real size(const Real& w) const { return std::max(below_.size(w), above_.size(w)); }
  [[nodiscard]] Real held_for_certain() const {
    return std::min(below_.held_for_certain(), above_.held_for_certain());
  }
  [[nodiscard]] Real excess(const Load<Real>& load, int sign) const {
    return toward(sign).excess(load, sign);
  }
  [[nodiscard]] Real sharpened(const Real& rounded, const Load<Real>& load, int sign) const {
    return toward(sign).sharpened(rounded, load, sign);
  }
  [[nodiscard]] int drives(const Load<Real>& load) const { return toward(sign(load)).drives(load); }

 private:
  Hold<Real> below_;
  Hold<Real> above_;
};

template <class Real>
class ZonedFriction {
 public:
  static constexpr bool in_zones = true;
  static constexpr bool damped = false;

  ZonedFriction(const BasicOscillator<Real>& oscillator, const BasicSurface<Real>& surface,
                const BasicStart<Real>& start)
      : p_(oscillator.p),
        notched_(oscillator.delta > 0 && !surface.notch_width),
        lets_go_(notched_ && oscillator.hold),
        h_(lets_go_ ? *oscillator.hold : Real(0)),
        spare_(h_ / p_),
        half_width_(surface.notch_width ? Real(p_ * (*surface.notch_width / 2)) : Real(-1)),
        walled_(oscillator.delta > 0 && surface.notch_width),
        leaving_(surface.notch_width && start.x0 == 0 && start.v0 != 0) {
    const Real wall = surface.notch_width ? Real(oscillator.delta / *surface.notch_width) : Real(0);
    Real from(0);
    const auto add = [&](const Real& f) {
      const Real notch = from < half_width_ ? wall : Real(0);
      const Real held = oscillator.breakaway * f + notch;
      zones_.push_back({from, held, Real(held / p_), Real((f + notch) / p_), Real(f / p_)});
    };
    for (const BasicFrictionZone<Real>& zone : surface.zones) {
      const Real to = p_ * zone.to;
      for (; from < to; from = from < half_width_ && half_width_ < to ? half_width_ : to) {
        add(zone.f);
      }
    }
    for (; from < half_width_; from = half_width_) {
      add(oscillator.f);
    }
    add(oscillator.f);
  }

  [[nodiscard]] const Real& phi_ahead(const Real& y) const {
    const Zone& zone = zones_[ahead(y)];
    return leaving_ ? zone.phi_leaving : zone.phi;
  }

  /// The same without the notch.
  [[nodiscard]] const Real& phi_alone(const Real& y) const { return zones_[ahead(y)].phi_leaving; }

  /// What friction loses as the mass sets off from y: rule 2 of docs/damping.md.
  [[nodiscard]] Real lost_ahead(const Real& y) const {
    const Zone& zone = zones_[ahead(y)];
    return zone.phi_held - zone.phi;
  }

  /// Where friction changes next, or a notch at x = 0 takes its part.
  [[nodiscard]] Real edge_ahead(const Real& y) const {
    const std::size_t zone = ahead(y);
    if (y < 0 && (zone > 0 || notched_)) {
      return 0 - zones_[zone].from;
    }
    return zone + 1 < zones_.size() ? zones_[zone + 1].from : std::numeric_limits<Real>::max();
  }

  [[nodiscard]] Real capacity(const Real& u, int sign) const {
    return one_sided(u, sign > 0 ? Real(-u) : u).phi(sign);
  }

  [[nodiscard]] EdgeHold<Real> hold_at(const Real& u) const {
    return EdgeHold<Real>([&](int sign) { return one_sided(u, sign > 0 ? Real(-u) : u); });
  }

  [[nodiscard]] bool lets_go() const { return lets_go_; }
  [[nodiscard]] bool at_notch(const Real& u) const { return lets_go_ && u == 0; }
  [[nodiscard]] const Real& spare() const { return spare_; }

  [[nodiscard]] Real from_edge(const Real& distance) const {
    Real least = distance;
    for (const Zone& zone : zones_) {
      least = std::min(least, magnitude(Real(distance - zone.from)));
    }
    return least;
  }

  /// The notch acts on a mass that has left it, or has turned before: rule 3.
  void rest() { leaving_ = false; }
  void reach(const Real& edge) { leaving_ = leaving_ && edge < half_width_; }

  [[nodiscard]] Real most_held(const Real& u) const {
    return std::max(capacity(u, -1), capacity(u, 1));
  }

  [[nodiscard]] bool notch_holds(const Real& u, bool came_there) const {
    return (walled_ && magnitude(u) <= half_width_) ||
           (notched_ && u == 0 && (came_there || lets_go_));
  }

  [[nodiscard]] Outcome rest_at(const Real& u) const {
    return u == 0                        ? Outcome::stopped_at_zero
           : magnitude(u) <= half_width_ ? Outcome::stopped_in_notch
                                         : Outcome::stopped_in_dead_zone;
  }

  /// The most that friction takes of v^2 + u^2 between two passages of x = 0, within |u|.
  [[nodiscard]] Real most_taken(const Real& u) const {
    Real taken(0);
    Real to = magnitude(u);
    for (auto zone = zones_.rbegin(); zone != zones_.rend(); ++zone) {
      if (zone->from < to) {
        taken += 4 * zone->phi * (to - zone->from);
        to = zone->from;
      }
    }
    return taken;
  }

  /// A motion within |u| loses nothing any more, or rests, no farther out than here.
  [[nodiscard]] Real farthest_end(const Real& u) const {
    Real farthest(0);
    bool frictionless = !notched_;
    for (const Zone& zone : zones_) {
      if (zone.from < magnitude(u)) {
        farthest = std::max({farthest, zone.phi_held, frictionless ? zone.from : Real(0)});
        frictionless = frictionless && zone.phi == 0;
      }
    }
    return farthest;
  }

  /// Whether nothing takes energy from a motion within |u|. Turns beyond a zone without friction
  /// close in on its edge, and rounding keeps them a few ulp beyond it.
  [[nodiscard]] bool frictionless_up_to(const Real& u) const {
    const Real within = magnitude(u) * (1 - 8 * std::numeric_limits<Real>::epsilon());
    return !notched_ && std::ranges::all_of(zones_, [&](const Zone& zone) {
      return zone.phi == 0 || !(zone.from < within);
    });
  }

 private:
  struct Zone {
    Real from;         ///< its edge towards x = 0
    Real held;         ///< f at rest
    Real phi_held;     ///< over p
    Real phi;          ///< f / p of a mass that slides
    Real phi_leaving;  ///< without the notch
  };

  /// The zone that the motion goes on in.
  [[nodiscard]] std::size_t ahead(const Real& y) const {
    std::size_t zone = zones_.size() - 1;
    while (zone > 0 && (y < 0 ? !(zones_[zone].from < -y) : zones_[zone].from > y)) {
      --zone;
    }
    return zone;
  }

  [[nodiscard]] Hold<Real> one_sided(const Real& u, const Real& y) const {
    const Zone& zone = zones_[ahead(y)];
    if (at_notch(u)) {
      return {p_, zone.held, zone.phi_held, u, h_, spare_};
    }
    return {p_, zone.held, zone.phi_held, u};
  }

  Real p_;
  bool notched_;  ///< at x = 0 alone
  bool lets_go_;
  Real h_;
  Real spare_;
  Real half_width_;  ///< p w/2; below 0 without such a notch
  bool walled_;      ///< the notch adds to the friction there
  bool leaving_;     ///< since the start, freely
  std::vector<Zone> zones_;
};

}  // namespace stillpoint
