// SPDX-License-Identifier: MIT
#pragma once

#include "way/extent.hpp"
#include "way/way.hpp"

#include <stillpoint/design/objective.hpp>
#include <stillpoint/design/problem.hpp>

#include <cmath>

namespace stillpoint::design {

/// The best point of a way so far, judged by the way itself.
class BestPoint {
 public:
  BestPoint(const Way& way, Objective objective) : way_(way), objective_(objective) {}

  /// With the best Delta for it.
  void consider(double f);
  void consider(double f, double delta);
  /// Of which the largest tolerance is known.
  void consider(const DesignPoint& candidate);

  [[nodiscard]] double cost() const { return cost_; }
  /// f and Delta alone.
  [[nodiscard]] const DesignPoint& place() const { return point_; }
  /// With its largest tolerance.
  [[nodiscard]] DesignPoint point() const;

 private:
  [[nodiscard]] bool may_be_better(double f) const;

  const Way& way_;
  Objective objective_;
  DesignPoint point_;
  double cost_{HUGE_VAL};
};

/// Within the distance that a design keeps from its edges, a later way is no better than an earlier
/// one, nor is NLopt's point than the one along f: its last digits depend on its version and on the
/// processor.
inline constexpr double clearly_better = 1e-8;

/// The least p T / pi of the first half-cycle for a from `low` to `high`. The time of a return to
/// x = 0 grows with a up to a3; if the mass rests before, beyond a3, that falls: (5), (6).
[[nodiscard]] double first_half_turn(double low, double high);

/// Considers the optimum of a way, found along f alone and without NLopt: docs/theory.md sections 8
/// and 12. With +, -, *, / and square roots, and what elementary.hpp makes of them, so that it has
/// the same bits on every machine.
void consider_along_f(const Way& way, Objective objective, const DesignRange& range,
                      BestPoint& best);

}  // namespace stillpoint::design
