// SPDX-License-Identifier: MIT
#pragma once

// What the motions of one f do along a leg: docs/theory.md section 15.

#include "pulse/first_return.hpp"

#include <cstddef>
#include <vector>

namespace stillpoint::design {

/// Some of the pulses and springs that stand for all of the ranges of lambda and p: one leg of (61)
/// of docs/theory.md. In units of the strongest pulse, k, and of the softest spring, p, as
/// first_return.hpp. Those along which lambda/p grows, s times from the first: either the spring
/// gets softer or the pulse shorter.
struct Leg {
  Pulse first;  ///< k = 1
  double p{1};
  bool softens{false};
  std::vector<double> stops;  ///< the s to look at
  double zeta{0};

  [[nodiscard]] Pulse pulse_at(double s) const {
    return softens ? first : with(first, 1, angular_frequency(first) * s);
  }
  [[nodiscard]] double p_at(double s) const { return softens ? p / s : p; }
  [[nodiscard]] FirstReturn at(double s, double f) const {
    return rescaled(first_return(pulse_at(s), p_at(s), f, zeta), 1, p_at(s));
  }
};

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
