// SPDX-License-Identifier: MIT
#pragma once

// The pulses and springs that stand for all of the ranges of lambda and p, (61) of docs/theory.md,
// and the worst of their motions for one f. In units of the strongest pulse, k, and of the softest
// spring, p, as first_return.hpp.

#include "pulse/along_leg.hpp"

#include <stillpoint/design/problem.hpp>
#include <stillpoint/design/pulse.hpp>

#include <array>
#include <vector>

namespace stillpoint::design {

class Legs {
 public:
  explicit Legs(const PulseProblem& problem);

  /// One pulse and one spring.
  [[nodiscard]] bool is_single() const { return legs_.empty(); }
  /// The longest pulse on the stiffest spring, and the shortest one on the softest.
  [[nodiscard]] std::array<Pulse, 2> ends() const;

  struct Worst {
    /// Each figure is the largest, and it returns if all do. What belongs to the need is that of
    /// the largest need; the clearance is the least of those that are no jump.
    FirstReturn motion;
    /// The motion with the largest peak.
    Pulse pulse;
    double p{1};
  };
  [[nodiscard]] Worst at(double f) const;

 private:
  Criterion criterion_;
  Pulse softest_;  ///< and longest, on the softest spring
  double zeta_;
  std::vector<Leg> legs_;
};

}  // namespace stillpoint::design
