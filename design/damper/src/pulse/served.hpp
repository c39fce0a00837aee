// SPDX-License-Identifier: MIT
#pragma once

// A damper under weaker and stronger pulses, and with other springs: docs/theory.md (71), (72).

#include "pulse/worst_return.hpp"
#include "region/limit_table.hpp"

#include <stillpoint/design/pulse.hpp>

#include <array>

namespace stillpoint::design {

/// What the motion under a pulse leaves of each requirement of a damper, >= 0 where it is kept. The
/// motion is in units of that k and p.
struct DamperRooms {
  DamperRooms(const PulseProblem& problem, const Limits& limits, double friction,
              double point_friction);

  [[nodiscard]] double peak(const FirstReturn& motion, double k, double p) const;
  [[nodiscard]] double stop(const FirstReturn& motion, double k, double p, Criterion by) const;
  /// The least of all.
  [[nodiscard]] double room(const FirstReturn& motion, double k, double p) const;

  double f;
  double delta;
  double beta;
  Criterion criterion;
  std::array<double, figure_count> figures_max{};
};

/// The largest k with the peak within beta, or the need within delta, of a motion with that f/k.
[[nodiscard]] double farthest_k(const DamperRooms& damper, const FirstReturn& motion, double p);
[[nodiscard]] double stopped_k(const DamperRooms& damper, const FirstReturn& motion, double p,
                               Criterion by);

/// The motions over f/k, each the worst of the lengths and springs of the ranges, whatever k is.
[[nodiscard]] WorstReturn for_any_k(PulseProblem problem);

}  // namespace stillpoint::design
