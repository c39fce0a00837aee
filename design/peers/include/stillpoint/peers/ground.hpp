// SPDX-License-Identifier: MIT
#pragma once

// What the mass slides on, as an integrator needs it: docs/notches.md section 2. y = s x is the
// place in the direction s of the motion.

#include <stillpoint/peers/scene.hpp>

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

namespace stillpoint::peers {

class Ground {
 public:
  explicit Ground(const Scene& scene) : oscillator_(scene.oscillator), zones_(scene.surface.zones) {
    for (const FrictionZone& zone : zones_) {
      edges_.push_back(zone.to);
    }
    if (scene.surface.notch_width) {
      half_width_ = *scene.surface.notch_width / 2;
      wall_ = oscillator_.delta / *scene.surface.notch_width;
      leaving_ = scene.start.x0 == 0 && scene.start.v0 != 0;
      edges_.push_back(half_width_);
    }
    if (!edges_.empty()) {
      edges_.push_back(0);  // where a passage is counted
    }
  }

  /// The square of the speed that a passage of a notch without a width takes.
  [[nodiscard]] double notch() const { return half_width_ < 0 ? 2 * oscillator_.delta : 0; }
  /// Whether that notch releases a mass that it has stopped.
  [[nodiscard]] bool lets_go() const { return notch() > 0 && oscillator_.hold; }

  /// Friction just beyond |x| = `distance`; with `more` times that of f and the zones.
  [[nodiscard]] double friction(double distance, double more = 1) const {
    const auto zone = std::ranges::upper_bound(zones_, distance, {}, &FrictionZone::to);
    const double f = more * (zone == zones_.end() ? oscillator_.f : zone->f);
    return distance < half_width_ && !leaving_ ? f + wall_ : f;
  }
  [[nodiscard]] double friction_towards(double s, double x, double more = 1) const {
    const double y = s * x;
    return friction(y >= 0 ? y : std::nextafter(-y, 0.0), more);
  }
  /// The load c that holds a mass at rest at x against a motion in the direction s.
  [[nodiscard]] double capacity(double s, double x) const {
    return friction_towards(s, x, oscillator_.breakaway) +
           (x == 0 && lets_go() ? *oscillator_.hold : 0);
  }

  /// The y of the next event of the law; infinite where there is none.
  [[nodiscard]] double edge_towards(double s, double x) const {
    const double y = s * x;
    double next = y < 0 && notch() > 0 ? 0 : std::numeric_limits<double>::infinity();
    for (const double edge : edges_) {
      for (const double there : {-edge, edge}) {
        next = there > y ? std::min(next, there) : next;
      }
    }
    return next;
  }

  /// How far `distance` is from where the law changes; infinite if it changes nowhere.
  [[nodiscard]] double from_change(double distance) const {
    double least = notch() > 0 ? distance : std::numeric_limits<double>::infinity();
    for (const double edge : edges_) {
      least = std::min(least, std::abs(distance - edge));
    }
    return least;
  }

  /// A notch with a width acts on a mass that has left it, or has turned before.
  void rest() { leaving_ = false; }
  void reach(double distance) { leaving_ = leaving_ && distance < half_width_; }

  [[nodiscard]] Outcome rest_at(double x) const {
    return x == 0                       ? Outcome::stopped_at_zero
           : std::abs(x) <= half_width_ ? Outcome::stopped_in_notch
                                        : Outcome::stopped_in_dead_zone;
  }

 private:
  Oscillator oscillator_;
  std::vector<FrictionZone> zones_;
  std::vector<double> edges_;
  double half_width_{-1};  ///< below 0 without such a notch
  double wall_{0};
  bool leaving_{false};  ///< since the start, freely
};

}  // namespace stillpoint::peers
