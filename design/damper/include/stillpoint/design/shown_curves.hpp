// SPDX-License-Identifier: MIT
#pragma once

// What is drawn of a shown motion: its envelope, its orbit, its energies, its load and another
// motion beside it.

#include <stillpoint/core/excitation.hpp>
#include <stillpoint/design/shown_motion.hpp>

#include <algorithm>
#include <array>
#include <cstddef>
#include <vector>

namespace stillpoint::design {

/// From the least value to the largest, 0 included.
template <class Item>
Interval extent(const std::vector<Item>& items, double Item::*value) {
  Interval seen{0, 0};
  for (const Item& item : items) {
    seen = {std::min(seen.low, item.*value), std::max(seen.high, item.*value)};
  }
  return seen;
}

/// With more half-cycles than can be told apart, the envelope is drawn. A load turns the mass
/// several times in some of them.
inline constexpr std::size_t most_single_half_cycles = 40;
[[nodiscard]] bool is_long(const ShownMotion& motion);
[[nodiscard]] bool is_long(const OtherMotion& other);
/// The line through the crests on one side (1 or -1) of a motion whose turns are too many.
[[nodiscard]] std::vector<State> crests(const std::vector<State>& states,
                                        const std::vector<State>& turns, double side,
                                        bool rests = false);

/// As far as the motion is shown.
[[nodiscard]] OtherMotion beside(const ShownMotion& motion, std::vector<State> states);
/// Whether they can be told apart.
[[nodiscard]] bool is_apart(const ShownMotion& motion, const std::vector<State>& other);

/// The way through the plane of x and v.
struct ShownOrbit {
  std::vector<std::vector<State>> arcs;     ///< in one piece each
  std::vector<std::array<State, 2>> jumps;  ///< of the velocity, from one arc to the next
  bool repeats{false};  ///< only its first two turns: without friction a free motion repeats them
  bool some{false};     ///< only some of the turns of a long motion
};
[[nodiscard]] ShownOrbit shown_orbit(const ShownMotion& motion);

/// Of a free motion at tau, by its mass: what is left, and what each friction took up to then.
struct ShownEnergy {
  double tau{0};
  double left{0};
  double friction{0};
  double notch{0};
  double damping{0};
};
[[nodiscard]] std::vector<ShownEnergy> shown_energies(const ShownMotion& motion);

/// What resists the displacement at tau, over the weight: friction and damping, and all that the
/// structure feels. Where friction changes at once, an instant has both values.
struct ShownForce {
  double tau{0};
  double x{0};
  double damper{0};
  double whole{0};
};
/// Of states of the motion in order of time, from its start or a turn on, to its rest.
[[nodiscard]] std::vector<ShownForce> shown_forces(const ShownMotion& motion,
                                                   const Excitation& excitation,
                                                   const std::vector<State>& states);

/// W at the instants that show it, from 0 to the horizon.
struct ShownLoad {
  double tau{0};
  double load{0};
};
[[nodiscard]] std::vector<ShownLoad> shown_load(const Excitation& excitation, double horizon);
/// What the structure feels, as far as the motion is shown: at rest W.
[[nodiscard]] std::vector<ShownLoad> shown_transmitted(const ShownMotion& motion,
                                                       const Excitation& excitation);

}  // namespace stillpoint::design
