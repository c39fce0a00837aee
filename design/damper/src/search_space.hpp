// SPDX-License-Identifier: MIT
#pragma once

// The search as NLopt sees it, docs/theory.md section 8, in the units of unit_problem.hpp:
//
//   x = a / a_cap,  y = d / d_cap,  t = tolerance of the box (a variable for `robust` alone)
//
//   amplitude  a2 / a_cap - x (1 - t)               <= 0      (only where a2 > 0)
//   return     x (1 + t) - 1                        <= 0      (and f_max)
//   start      y (1 + t) - 1                        <= 0      (and delta_max)
//   stop       Delta1(a (1 - t)) / d_cap - y (1 - t) <= 0
//
// x and y are scaled by the caps, not by the width of the region, which may vanish.
//
// The objectives in the units of unit_problem.hpp, one row each in objectives.cpp.

#include "nlopt_fence.hpp"

#include <stillpoint/design/search.hpp>

namespace stillpoint::design {

struct SearchSpace {
  Criterion criterion{Criterion::published};
  Objective objective{Objective::robust};
  double tolerance{0};  ///< the requested one; for `robust` the lower bound of t
  double a2{0};
  double a_cap{0};
  double d_cap{0};

  /// Called with every (x, y) at which the objective is evaluated.
  std::function<void(double x, double y)> visit;
};

/// With the constraints as NLopt's own, gradients included; starts at (x, y).
[[nodiscard]] NloptProblem constrained(const SearchSpace& space, double x, double y);

/// For algorithms that know only bounds: outside the region the violation, raised above every
/// value inside; `tolerance_at` gives the tolerance of a point inside.
[[nodiscard]] NloptProblem penalised(const SearchSpace& space, double x, double y,
                                     const std::function<double(double x, double y)>& tolerance_at);

/// The objective's value at `given` = f / (V0 p) for those that have a closed form, and its slope.
/// All values are of order one, so that one set of stopping rules serves them. `robust` has none:
/// its variable is the tolerance of the box.
[[nodiscard]] double objective_value(Objective objective, double given);
[[nodiscard]] double objective_slope(Objective objective, double given);

}  // namespace stillpoint::design
