// SPDX-License-Identifier: MIT
#pragma once

#include <stillpoint/design/problem.hpp>

namespace stillpoint::design {

/// Whether every f (1 +- R), delta (1 +- R) keeps all constraints and limits, R = limits.tolerance.
/// The initial velocity may depend on f and fall with it: `at_low` is the problem at f (1 - R),
/// `at_high` that at f (1 + R).
[[nodiscard]] bool box_admissible(const Problem& at_low, const Problem& at_high,
                                  const Limits& limits, double f, double delta);

}  // namespace stillpoint::design
