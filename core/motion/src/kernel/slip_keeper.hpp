// SPDX-License-Identifier: MIT
#pragma once

// A watcher of free_run.hpp that adds up the distance slid, from peak to peak, and keeps the
// largest speed: docs/forced.md section 11. In the units of half_cycle_map.hpp.

#include "kernel/exact_sum.hpp"
#include "kernel/first_leg.hpp"
#include "kernel/free_run.hpp"
#include "kernel/half_cycle_map.hpp"

#include <algorithm>
#include <cmath>

namespace stillpoint {

class SlipKeeper {
 public:
  using Map = HalfCycleMap<double>;

  void first_leg(const Map& map, const FirstLeg<double>& leg) {
    const bool outward = leg.end == FirstLegEnd::peak;
    const bool slides = outward || leg.end == FirstLegEnd::arrival || leg.end == FirstLegEnd::rest;
    fastest_ = !slides || outward || leg.distance <= map.phi ? leg.speed : leg.radius;
    if (leg.end == FirstLegEnd::arrival) {
      slid_.add(leg.distance);
    } else {
      reach(map, leg.farthest);
      slid_.add(outward ? leg.farthest - leg.distance : 0);
    }
  }

  void first_passage(const Map& map, double energy, double radius) {
    reach(map, map.peak(energy, radius));
    slid_.add(peak_);
  }

  /// The peaks are n + 1 terms of an arithmetic series.
  void constant_friction(const Map& /*map*/, double passages, double last) {
    slid_.add_product(passages, peak_ + last);
    peak_ = last;
  }

  /// (F38): v^2 at x = 0 grows by the notch from the last peak to the first.
  void point_friction(const Map& map, double passages, double last) {
    if (passages == 0) {
      return;
    }
    constexpr double one_by_one = 1000;
    const double d = map.notch;
    double sum = 0;
    const double few = std::min(passages, one_by_one);
    for (double n = 0; n < few; ++n) {
      sum += std::sqrt(last + n * d);
    }
    if (passages > few) {
      const double from = last + few * d;
      const double to = last + (passages - 1) * d;
      const auto terms = [d](double e) {
        return std::sqrt(e) * (2 * e / (3 * d) + d / e * (1.0 / 24 - d / e * d / e / 1920));
      };
      sum += terms(to) - terms(from) + (std::sqrt(from) + std::sqrt(to)) / 2;
    }
    const double lowest = std::sqrt(last);
    slid_.add(2 * sum + (peak_ - lowest));
    peak_ = lowest;
  }

  void passage(const Map& map, double /*arrival*/, double energy, double radius) {
    slid_.add(peak_);
    peak_ = map.peak(energy, radius);
    slid_.add(peak_);
  }

  void arrival(const Map& /*map*/, double /*energy*/) {}
  void crest(const Map& /*map*/, double /*radius*/) {}
  void stops_at_zero(const Map& /*map*/, double /*passages*/, double /*arrival*/) {}
  void stops_in_dead_zone(double /*passages*/, bool /*swings_back*/) {}

  /// p times the distance, and the largest |x'|; the motion has ended.
  [[nodiscard]] double slid(const FreeRun<double>& run) const {
    ExactSum<double> all = slid_;
    all.add(peak_ - std::abs(run.rest));
    return all.value();
  }
  [[nodiscard]] double fastest() const { return fastest_; }

 private:
  /// On the way back from there the mass is fastest where friction and spring cancel.
  void reach(const Map& map, double peak) {
    peak_ = peak;
    fastest_ = std::max(fastest_, peak - map.phi);
  }

  ExactSum<double> slid_;
  double peak_{0};  ///< the last, from which it has not yet come back
  double fastest_{0};
};

}  // namespace stillpoint
