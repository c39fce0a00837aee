// SPDX-License-Identifier: MIT
#pragma once

#include <stillpoint/design/problem.hpp>

#include <optional>

namespace stillpoint::design {

/// A smaller one is none: the distance that a design keeps from an edge, and rounding.
inline constexpr double least_tolerance = 1e-6;

/// All five constraints and the limits, over the box of relative half-width `limits.tolerance`
/// around (f, delta): its worst corner is (f (1 - tolerance), delta (1 - tolerance)) for the stop,
/// because Delta1 falls with f.
[[nodiscard]] bool admissible(const Problem& problem, const Limits& limits, double f, double delta);

/// The largest tolerance for which the box around (f, delta) is admissible, for any
/// `limits.tolerance`; empty if the point itself is not.
[[nodiscard]] std::optional<double> largest_tolerance(const Problem& problem, const Limits& limits,
                                                      double f, double delta);

/// The largest f up to which any constant friction, however little, is admissible with every Delta
/// within delta (1 +- tolerance), good to 1e-6 of the largest f of any damper; empty if none is.
/// limits.tolerance and limits.shape are not looked at.
[[nodiscard]] std::optional<double> any_f_up_to(const Problem& problem, Limits limits, double delta,
                                                double tolerance);

/// Of the dampers that the task admits at tolerance 0, the one with the largest tolerance, if that
/// is less than the one asked for; otherwise empty, also if no damper has any tolerance.
[[nodiscard]] std::optional<DesignPoint> most_tolerant(const Problem& problem,
                                                       const Limits& limits);

}  // namespace stillpoint::design
