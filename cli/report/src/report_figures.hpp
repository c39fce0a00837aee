// SPDX-License-Identifier: MIT
#pragma once

// What is drawn of a motion, a region and a sweep, and the figures of it.

#include "units.hpp"

#include <stillpoint/core/simulation.hpp>
#include <stillpoint/core/state.hpp>
#include <stillpoint/design/pulse.hpp>
#include <stillpoint/design/region.hpp>
#include <stillpoint/figures/figure.hpp>
#include <stillpoint/sweep/map.hpp>

#include <cstdint>
#include <functional>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace stillpoint::report {

/// A motion as its figures need it.
struct DrawnMotion {
  Oscillator oscillator;
  std::vector<State> states;    ///< samples and every event; a passage has two at one instant
  std::vector<State> turns;     ///< peaks
  std::vector<State> passages;  ///< of x = 0, with the speed after the notch
  std::optional<State> rest;    ///< the end of the motion
  std::vector<std::pair<double, double>> sticks;  ///< tau from, to
  std::optional<double> beta;
  bool whole{true};  ///< else only its beginning
};

/// Of a longer motion only the beginning is drawn: so many half-cycles, and periods of the spring
/// or of the load, whichever is faster.
inline constexpr std::int64_t most_drawn_half_cycles = 200;
inline constexpr double most_drawn_periods = 100;

/// Evenly spaced points that make a curve of an angular frequency look smooth up to tau =
/// `horizon`.
[[nodiscard]] std::int64_t sample_count(double rate, double horizon);

/// A free motion up to `horizon`; empty: to its end.
[[nodiscard]] DrawnMotion drawn_free_motion(const Oscillator& oscillator, const Start& start,
                                            const std::optional<double>& horizon);
/// A forced one up to `horizon`, or one on a surface of its own.
[[nodiscard]] DrawnMotion drawn_forced_motion(const Oscillator& oscillator, const Start& start,
                                              const Excitation& excitation, double horizon,
                                              const Surface& surface = {});
/// The motion of an answer, or its beginning.
[[nodiscard]] DrawnMotion drawn_motion(const SimulationRequest& request, const Simulation& answer);

[[nodiscard]] figures::Figure motion_figure(const DrawnMotion& motion, const FigureUnits& units);
[[nodiscard]] figures::Figure phase_figure(const DrawnMotion& motion, const FigureUnits& units);
/// Of a free motion: what is left of the energy, and what each friction took.
[[nodiscard]] figures::Figure energy_figure(const DrawnMotion& motion, const FigureUnits& units);
/// W over the same time as the motion.
[[nodiscard]] figures::Figure excitation_figure(const Excitation& excitation,
                                                const DrawnMotion& motion,
                                                const FigureUnits& units);

/// A point of the (f, Delta) plane and the tolerance it withstands.
struct DrawnDamper {
  std::string name;
  double f{0};
  double delta{0};
  double tolerance{0};
};

/// The problem at a constant friction f: another one for each f where a pulse leaves the velocity.
using ProblemAt = std::function<design::Problem(double)>;

/// What there is to draw of a region.
struct DrawnRegion {
  design::Problem problem;
  design::Limits limits;
  design::Region region;
  std::optional<DrawnDamper> damper;
  std::optional<design::PulseProblem> pulse;
};

/// The admissible region in the (f, Delta) plane, its edges by name, and a point in it.
[[nodiscard]] figures::Figure region_figure(const DrawnRegion& drawn, const FigureUnits& units);

/// The analytic boundaries alone, within the axes of the figure.
void add_boundaries(figures::Figure& figure, const design::Problem& problem,
                    const FigureUnits& units);

/// The plane of f and Delta, coloured by how the motions end and after how many half-cycles; of
/// free motions from x = 0 with the analytic boundaries on top.
[[nodiscard]] figures::Figure sweep_figure(const sweep::SweepSpec& spec,
                                           const sweep::SweepMap& map);

}  // namespace stillpoint::report
