// SPDX-License-Identifier: MIT
#pragma once

// The objectives in the units of unit_problem.hpp, one row each in objectives.cpp.

#include "pulse/first_return.hpp"

#include <stillpoint/design/objective.hpp>
#include <stillpoint/design/problem.hpp>

namespace stillpoint::design {

/// The objective's value at `given` = f / (V0 p) for those that have a closed form, and its slope.
/// All values are of order one, so that one set of stopping rules serves them. `robust` has none:
/// its variable is the tolerance of the box. `time` is that of a stop at the first arrival.
[[nodiscard]] double objective_value(Objective objective, double given);
[[nodiscard]] double objective_slope(Objective objective, double given);
/// Each grows or falls over all f, except `time` where it is not that of the first arrival.
[[nodiscard]] bool falls_with_f(Objective objective);
/// The value of one in tau and g; -1 for `robust`, since a search minimises.
[[nodiscard]] double objective_unit(Objective objective, const Problem& problem);
/// The objective of a motion under a pulse; not for `robust`.
[[nodiscard]] double objective_of(Objective objective, const FirstReturn& motion);
/// Such a value, which is in units of k and p as first_return.hpp says, in tau and g.
[[nodiscard]] double in_pulse_units(Objective objective, double value, double k, double p);

}  // namespace stillpoint::design
