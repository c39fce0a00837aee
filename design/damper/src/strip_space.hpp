// SPDX-License-Identifier: MIT
#pragma once

// The search of one strip as NLopt sees it, docs/theory.md section 12: as search_space.hpp, with
// y = d / d_cap and the two corners of the box instead of the last two conditions there,
//
//   reach   (46) at (a (1 + t), d (1 + t)) - 1   <= 0
//   stop    1 - (46) at (a (1 - t), d (1 - t))   <= 0
//   limit   y (1 + t) - 1                        <= 0      (delta_max)

#include "nlopt_fence.hpp"
#include "strip.hpp"

#include <stillpoint/design/search.hpp>

#include <vector>

namespace stillpoint::design {

/// The scale of y.
[[nodiscard]] double d_scale(const StripTask& task);

/// What the objective minimises at (a, d), of order one; `robust` has no closed form.
[[nodiscard]] double strip_cost(const StripTask& task, Objective objective, double a, double d);

/// What an algorithm has tried: every x, and of one without constraints the best point.
struct Tried {
  std::vector<double> x;
  double value;
  Eigen::Vector2d best;
};

[[nodiscard]] NloptProblem strip_posed(ConstraintSupport support, const StripTask& task,
                                       Objective objective, const DesignPoint& start, Tried& tried);

}  // namespace stillpoint::design
