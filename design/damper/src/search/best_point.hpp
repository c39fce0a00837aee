// SPDX-License-Identifier: MIT
#pragma once

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

}  // namespace stillpoint::design
