// SPDX-License-Identifier: MIT
#pragma once

#include "pulse/first_return.hpp"

#include <stillpoint/design/design_result.hpp>

namespace stillpoint::design {

/// A point that was found, simulated and checked.
[[nodiscard]] Found finding_of(const Problem& problem, const Limits& limits,
                               const DesignPoint& point);

/// The same for a pulse, without its constraints and its practice. `expected` is the motion that
/// the search had, in its units; the forced motion with this Delta and Runge-Kutta integration are
/// the checks of it.
[[nodiscard]] Found finding_under_pulse(const PulseProblem& problem, const DesignPoint& point,
                                        const FirstReturn& expected);

}  // namespace stillpoint::design
