// SPDX-License-Identifier: MIT
#pragma once

// What is drawn of a motion, over time and in the phase plane.

#include "units.hpp"

#include <stillpoint/core/state.hpp>
#include <stillpoint/design/shown_motion.hpp>
#include <stillpoint/figures/figure.hpp>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <functional>
#include <optional>
#include <string>
#include <vector>

namespace stillpoint::report {

/// States as points.
template <class Place>
std::vector<figures::FigurePoint> places(const std::vector<State>& states, const Place& place) {
  std::vector<figures::FigurePoint> points;
  points.reserve(states.size());
  for (const State& state : states) {
    points.push_back(place(state));
  }
  return points;
}

/// From the least value to the largest, 0 included.
template <class Item>
Interval extent(const std::vector<Item>& items, double Item::*value) {
  Interval seen{0, 0};
  for (const Item& item : items) {
    seen = {std::min(seen.low, item.*value), std::max(seen.high, item.*value)};
  }
  return seen;
}

/// Another motion from the same start, to compare with.
struct OtherMotion {
  std::string name;
  std::vector<State> states;
  Interval reach{};  ///< of x, also where it goes on beyond what is drawn
  figures::Ink ink{figures::Ink::grey};
  figures::Dash dash{figures::Dash::dotted};
  std::vector<State> turns{};  ///< of one that may be drawn as its envelope
  bool if_comparable{false};   ///< drawn only if it would not just cross the figure
};

/// A motion and what is drawn with it.
struct DrawnMotion : design::ShownMotion {
  std::vector<OtherMotion> others;  ///< those that do not hide it
  std::optional<double> beta;
  std::string with;  ///< "With the strongest hit, ", if it is one of several

  explicit DrawnMotion(ShownMotion shown);
};

/// With more half-cycles than can be distinguished, the envelope is drawn. A load turns the mass
/// several times in some of them.
inline constexpr std::size_t most_single_half_cycles = 40;
[[nodiscard]] inline bool is_long(const DrawnMotion& motion) {
  constexpr std::size_t most_turns = 3 * most_single_half_cycles;
  return motion.passages.size() > most_single_half_cycles || motion.turns.size() > most_turns;
}

/// Adds another motion to compare with, as far as the figure goes; only if it can be told apart.
void add(DrawnMotion& motion, OtherMotion other);
void add_if_visible(DrawnMotion& motion, OtherMotion other);

/// Whether it moves at all: a load may be too weak.
[[nodiscard]] bool is_moving(const DrawnMotion& motion);
/// " (beginning)" for a motion that is not drawn whole.
[[nodiscard]] std::string beginning(const DrawnMotion& motion);
/// Marks of events: turns and passages up to a tau, and the rest.
template <class Place>
void mark_events(figures::Figure& figure, const DrawnMotion& motion, const Place& place,
                 double last) {
  const auto those = [&](std::vector<State> states, const auto& are) {
    std::erase_if(states, [&](const State& at) { return at.tau > last || !are(at); });
    return places(states, place);
  };
  using figures::Fill;
  using figures::Ink;
  using figures::Shape;
  const auto goes_on = [&](const State& at) { return !motion.rest || at.tau != motion.rest->tau; };
  const auto& width = motion.surface.notch_width;
  const bool acts = motion.oscillator.delta > 0 && !width;
  const auto freed = [&](const State& at) { return acts && at.v == 0; };
  figure.marks.push_back(
      {"turn", those(motion.turns, goes_on), Shape::disc, Ink::blue, Fill::hollow});
  if (width) {
    const auto at_edge = [&](const State& at) { return std::abs(at.x) == *width / 2; };
    figure.marks.push_back(
        {"edge of the notch", those(motion.states, at_edge), Shape::cross, Ink::orange});
  } else {
    figure.marks.push_back(
        {"passage", those(motion.passages, std::not_fn(freed)), Shape::cross, Ink::orange});
    figure.marks.push_back({"stopped by the notch, then freed", those(motion.passages, freed),
                            Shape::diamond, Ink::orange, Fill::hollow});
  }
  if (motion.rest) {
    figure.marks.push_back({"rest", {place(*motion.rest)}, Shape::square, Ink::green});
  }
}

/// The notch with a width and the zones of other friction, as strips along an axis.
enum class Along { x, y };
void add_zones(figures::Figure& figure, const DrawnMotion& motion, double length, Along along);

/// The time from which the mass is locked, shaded.
void add_lock(figures::Figure& figure, const DrawnMotion& motion, const FigureUnits& units);

[[nodiscard]] figures::Figure motion_figure(const DrawnMotion& motion, const FigureUnits& units);
[[nodiscard]] figures::Figure phase_figure(const DrawnMotion& motion, const FigureUnits& units);
/// For a free motion: the energy left, and what each friction took.
[[nodiscard]] figures::Figure energy_figure(const DrawnMotion& motion, const FigureUnits& units);
/// W over the same time as the motion.
[[nodiscard]] figures::Figure excitation_figure(const Excitation& excitation,
                                                const DrawnMotion& motion,
                                                const FigureUnits& units);

}  // namespace stillpoint::report
