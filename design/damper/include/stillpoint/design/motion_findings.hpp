// SPDX-License-Identifier: MIT
#pragma once

// What a motion must say beyond its figures.

#include <stillpoint/core/simulation.hpp>
#include <stillpoint/design/cross_check.hpp>
#include <stillpoint/design/figures.hpp>
#include <stillpoint/design/finding.hpp>

#include <optional>
#include <vector>

namespace stillpoint::design {

/// Of a motion that was not cancelled. Motions with f and Delta slightly off are followed for that.
[[nodiscard]] std::vector<Finding> findings_of(const SimulationRequest& request,
                                               const Simulation& motion);

/// Of a check that failed.
void add_failed(std::vector<Finding>& all, const CrossCheck& check);

/// Of a forced motion that the notch holds at the end of a load that lasts until `load_end`.
[[nodiscard]] Finding lock_of(const ForcedResponse& motion, double load_end);

/// Of a load that moves the mass only out of a notch wider than `width`, which is wider than the
/// motion. Of a delta that was searched a smaller one is proposed: that of a notch which is to be
/// half as wide as the motion.
[[nodiscard]] Finding no_notch(double width, double peak, double searched_delta = 0);

/// A mass that feels more than this share of its load is not isolated.
inline constexpr double hardly_less = 0.95;

/// Where a mass may rest in a notch with a width, as a share of the peak, if no residual is given.
inline constexpr double rest_share = 0.1;

/// Of a pulse after which a notch stops the mass that does not act at the start: whether one with a
/// width, which does, stops it as well, at most `rest` off centre. `least_load` is the weakest that
/// must move the mass.
[[nodiscard]] Finding late_notch(const Oscillator& damper, const Excitation& pulse,
                                 double least_load, double peak, double rest,
                                 bool searched = false);

/// |v0| of a hit that the notch catches, which the structure then feels in full, per mass.
[[nodiscard]] std::optional<double> caught_impulse(const SimulationRequest& request,
                                                   const Response& response);

/// What constant friction holds at rest at x = 0, where zones change it.
[[nodiscard]] double holding_friction(const SimulationRequest& request);

/// The width from which on a notch lets `load` move the mass from rest; infinite if friction alone
/// holds it.
[[nodiscard]] double least_width(double f, double delta, double load);

/// Of a rest from the start on.
[[nodiscard]] bool moves(const Response& response);

}  // namespace stillpoint::design
