// SPDX-License-Identifier: MIT
#pragma once

// A way as NLopt sees it: x = a / a_cap, y = d / d_cap and, for `robust`, t = R.

#include "nlopt_fence.hpp"
#include "strip_space.hpp"
#include "way.hpp"

namespace stillpoint::design {

/// What the objective minimises, for the motion of the largest peak; of order one, -R for `robust`.
[[nodiscard]] double way_cost(const Way& way, Objective objective, const DesignPoint& point);

/// Starts at `start`; `tried` is told of every point.
[[nodiscard]] NloptProblem way_posed(ConstraintSupport support, const Way& way, Objective objective,
                                     const DesignPoint& start, Tried& tried);

}  // namespace stillpoint::design
