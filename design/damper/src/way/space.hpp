// SPDX-License-Identifier: MIT
#pragma once

// A way in NLopt's variables, docs/theory.md section 8, in the units of unit_problem.hpp:
//
//   x = a / a_cap,  y = d / d_cap,  t = tolerance of the box (a variable for `robust` alone)
//
//   amplitude  a2 / a_cap at the low side of f - x   <= 0      (only where a2 > 0)
//   cap        x at the high side - 1                <= 0      (the tip, and what bounds f)
//   start      y at the high side - 1                <= 0      (and delta_max)
//   return     reach_edge at the high corner         <= v_low^2
//   stop       last_edge, stop_edge at the low one   >= 1
//
// x and y are scaled by the caps, not by the width of the region, which may vanish.

#include "search/nlopt_fence.hpp"
#include "way/way.hpp"

#include <stillpoint/design/objective.hpp>
#include <stillpoint/design/problem.hpp>

#include <vector>

namespace stillpoint::design {

/// What the objective minimises, for the motion of the largest peak; of order one, -R for `robust`.
[[nodiscard]] double way_cost(const Way& way, Objective objective, const DesignPoint& point);

/// What an algorithm has tried: every x, and for one without constraints the best point.
struct Tried {
  std::vector<double> x;
  double value;
  Eigen::Vector2d best;
};

/// Starts at `start`; `tried` sees every point. For an algorithm that takes no constraints
/// the objective outside them is their violation, raised above every value inside.
[[nodiscard]] NloptProblem way_posed(ConstraintSupport support, const Way& way, Objective objective,
                                     const DesignPoint& start, Tried& tried);

}  // namespace stillpoint::design
