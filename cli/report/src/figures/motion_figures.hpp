// SPDX-License-Identifier: MIT
#pragma once

// What is drawn of a motion, over time and in the phase plane.

#include "figures/drawing.hpp"

#include <stillpoint/design/shown_curves.hpp>

#include <functional>

namespace stillpoint::report {

using design::extent;

/// Where a motion is drawn.
using Place = std::function<FigurePoint(const State&)>;
[[nodiscard]] Points places(const std::vector<State>& states, const Place& place);

/// Another motion from the same start, to compare with.
struct OtherMotion {
  std::string name;
  design::OtherMotion path;
  Ink ink{Ink::grey};
  Dash dash{Dash::dotted};
  bool if_comparable{false};  ///< drawn only if it would not just cross the figure
};

/// A motion and what is drawn with it.
struct DrawnMotion : design::ShownMotion {
  std::vector<OtherMotion> others;  ///< those that do not hide it
  std::optional<double> beta;
  std::string with;  ///< "With the strongest hit, ", if it is one of several

  explicit DrawnMotion(ShownMotion shown);
};

/// Up to the motion and the limit, and to other motions if those are not much larger.
[[nodiscard]] FigureAxis displacement_axis(const DrawnMotion& motion, const FigureUnits& units);
/// Those that would not just cross the figure as lines, with too many half-cycles to be told apart
/// the lines through their crests; of the rest how far they go.
void add_others(Figure& figure, const DrawnMotion& motion, const Place& place,
                const FigureUnits& units);

/// " (beginning)" for a motion that is not drawn whole.
[[nodiscard]] std::string beginning(const DrawnMotion& motion);
/// Marks of events: turns and passages up to a tau, and the rest.
void mark_events(Figure& figure, const DrawnMotion& motion, const Place& place, double last);
/// The notch with a width and the zones of other friction, as strips along an axis.
enum class Along { x, y };
void add_zones(Figure& figure, const DrawnMotion& motion, const FigureUnits& units, Along along);
/// The time from which the mass is locked, shaded.
void add_lock(Figure& figure, const DrawnMotion& motion, const FigureUnits& units);

/// Over the time of the motion.
[[nodiscard]] Figure over_time(std::string id, const std::string& title, const DrawnMotion& motion,
                               const FigureUnits& units);
[[nodiscard]] Figure motion_figure(const DrawnMotion& motion, const FigureUnits& units);
[[nodiscard]] Figure phase_figure(const DrawnMotion& motion, const FigureUnits& units);
/// For a free motion: the energy left, and what each friction took.
[[nodiscard]] Figure energy_figure(const DrawnMotion& motion, const FigureUnits& units);
/// Friction and damping over the displacement, alone and with the spring.
[[nodiscard]] Figure loop_figure(const Excitation& excitation, const DrawnMotion& motion,
                                 const FigureUnits& units);
/// What the structure feels, below the motion.
[[nodiscard]] Figure transmitted_figure(const Excitation& excitation, const DrawnMotion& motion,
                                        const FigureUnits& units);
/// W, below the motion.
[[nodiscard]] Figure excitation_figure(const Excitation& excitation, const DrawnMotion& motion,
                                       const FigureUnits& units);

}  // namespace stillpoint::report
