// SPDX-License-Identifier: MIT
#pragma once

// The curves of motions, and of others to compare with.

#include "figures/motion_figures.hpp"

#include <functional>
#include <string>
#include <vector>

namespace stillpoint::report {

/// Where a motion is drawn.
using Place = std::function<figures::FigurePoint(const State&)>;

/// The line through the crests on one side of a motion, whose turns are too many to be told apart.
[[nodiscard]] std::vector<figures::FigurePoint> crest_line(const std::vector<State>& states,
                                                           const std::vector<State>& turns,
                                                           double side, bool rests,
                                                           const Place& place);

/// Another motion is cut off at so many times the peak or the limit.
constexpr double farthest_shown = 1.4;

/// Whether another motion is drawn; an envelope only if all of it is seen.
[[nodiscard]] bool is_drawn(const DrawnMotion& motion, const OtherMotion& other);
/// "without friction, beyond the frame to -158 mm", if the frame cuts it off.
[[nodiscard]] std::string name_of(const OtherMotion& other, const figures::FigureAxis& axis,
                                  const FigureUnits& units);
/// Of one with too many half-cycles to be told apart the lines through its crests.
[[nodiscard]] std::vector<std::vector<figures::FigurePoint>> strokes_of(const OtherMotion& other,
                                                                        const Place& place);

}  // namespace stillpoint::report
