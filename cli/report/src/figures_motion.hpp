// SPDX-License-Identifier: MIT
#pragma once

#include "drawn_motion.hpp"
#include "units.hpp"

#include <stillpoint/figures/figure.hpp>

namespace stillpoint::report {

[[nodiscard]] figures::Figure motion_figure(const DrawnMotion& motion, const FigureUnits& units);
[[nodiscard]] figures::Figure phase_figure(const DrawnMotion& motion, const FigureUnits& units);
/// Of a free motion: what is left of the energy, and what each friction took.
[[nodiscard]] figures::Figure energy_figure(const DrawnMotion& motion, const FigureUnits& units);
/// W over the same time as the motion.
[[nodiscard]] figures::Figure excitation_figure(const Excitation& excitation,
                                                const DrawnMotion& motion,
                                                const FigureUnits& units);

}  // namespace stillpoint::report
