// SPDX-License-Identifier: MIT
#pragma once

// What the motions of one f do along a leg: docs/theory.md section 15.

#include "pulse/leg.hpp"

#include <cstddef>
#include <vector>

namespace stillpoint::design {

/// The motions at the stops of a leg, both sides of each jump between them, and the maxima of each
/// bounded figure; or one that does not return.
class AlongLeg {
 public:
  AlongLeg(const Leg& leg, double f);

  struct Spot {
    double s{1};
    FirstReturn motion;
    /// The need jumps from here to the next one.
    bool before_jump{false};
  };
  /// In the order of s. The clearance of the motion at a jump is that of the side that arrives.
  [[nodiscard]] const std::vector<Spot>& spots() const { return spots_; }
  [[nodiscard]] bool returns() const { return returns_; }
  /// The least clearance apart from jumps, the square of the least speed; negative where one does
  /// not return.
  [[nodiscard]] double clearance() const { return clearance_; }
  /// The slope over f of the need at a spot; at a jump, which moves with f, that of the need there.
  [[nodiscard]] double need_slope(std::size_t place, Criterion criterion) const;

 private:
  [[nodiscard]] Spot spot(double s) const { return {s, leg_.at(s, f_)}; }
  void split_kinds();
  bool split(std::size_t first);
  void insert(std::size_t place, const Spot& now);
  void seek_misses();
  template <class Figure, class Threshold>
  void raise(const Figure& figure, const Threshold& threshold);
  void found_miss(const FirstReturn& motion);

  const Leg& leg_;
  double f_;
  std::vector<Spot> spots_;
  bool returns_{true};
  double clearance_;
};

}  // namespace stillpoint::design
