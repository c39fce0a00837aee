// SPDX-License-Identifier: MIT
#pragma once

#include "figure_units.hpp"

#include <stillpoint/core/excitation.hpp>
#include <stillpoint/core/oscillator.hpp>
#include <stillpoint/core/state.hpp>
#include <stillpoint/figures/figure.hpp>

#include <optional>
#include <utility>
#include <vector>

namespace stillpoint::cli {

/// A motion as its figures need it.
struct DrawnMotion {
  Oscillator oscillator;
  std::vector<State> states;    ///< samples and every event; a passage has two at one instant
  std::vector<State> turns;     ///< peaks
  std::vector<State> passages;  ///< of x = 0, with the speed after the notch
  std::optional<State> rest;    ///< the end of the motion
  std::vector<std::pair<double, double>> sticks;  ///< tau from, to
  std::optional<double> beta;
  bool whole{true};  ///< else its beginning alone
};

/// So many half-cycles are drawn of a longer motion.
inline constexpr std::int64_t most_drawn_half_cycles = 200;
/// Of the spring or of the load, whichever is faster: as many.
inline constexpr double most_drawn_periods = 100;

/// The fastest that the motion can swing: p, or the excitation's lambda.
[[nodiscard]] double fastest_rate(double p, const Excitation& excitation);

/// A free motion up to `horizon`; empty: to its end.
[[nodiscard]] DrawnMotion drawn_free_motion(const Oscillator& oscillator, const Start& start,
                                            const std::optional<double>& horizon);
/// A forced one up to `horizon`.
[[nodiscard]] DrawnMotion drawn_forced_motion(const Oscillator& oscillator, const Start& start,
                                              const Excitation& excitation, double horizon);

[[nodiscard]] figures::Figure motion_figure(const DrawnMotion& motion, const FigureUnits& units);
[[nodiscard]] figures::Figure phase_figure(const DrawnMotion& motion, const FigureUnits& units);
/// Of a free motion: what is left of the energy, and what each friction took.
[[nodiscard]] figures::Figure energy_figure(const DrawnMotion& motion, const FigureUnits& units);
/// W over the same time as the motion.
[[nodiscard]] figures::Figure excitation_figure(const Excitation& excitation,
                                                const DrawnMotion& motion,
                                                const FigureUnits& units);

}  // namespace stillpoint::cli
