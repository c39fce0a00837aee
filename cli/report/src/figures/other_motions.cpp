// SPDX-License-Identifier: MIT
#include "figures/other_motions.hpp"
#include "format.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <iterator>
#include <utility>

namespace stillpoint::report {

using figures::FigurePoint;

namespace {

bool is_long(const OtherMotion& other) {
  return other.turns.size() > most_single_half_cycles;
}

/// The largest |x|.
double reach(const std::vector<State>& states) {
  const auto [least, most] = extent(states, &State::x);
  return std::max(most, -least);
}

}  // namespace

/// The farthest in each column of time, without those between two that are farther.
std::vector<FigurePoint> crest_line(const std::vector<State>& states,
                                    const std::vector<State>& turns, double side, bool rests,
                                    const Place& place) {
  constexpr double columns = 180;
  const double column = states.back().tau / columns;
  const State& first = states.front();
  const State held = *std::prev(std::ranges::find_if(  // until it first moves
      states, [&](const State& state) { return state.x != first.x; }));
  std::vector<State> crests;
  for (const State& turn : turns) {
    if (!crests.empty() &&
        std::floor(turn.tau / column) == std::floor(crests.back().tau / column)) {
      crests.back() = side * turn.x > side * crests.back().x ? turn : crests.back();
    } else {
      crests.push_back(turn);
    }
  }
  std::vector<FigurePoint> line{place(first), place(held)};
  for (std::size_t i = 0; i < crests.size(); ++i) {
    const auto is_farther = [&](std::size_t other) {
      return other >= crests.size() || side * crests[other].x > side * crests[i].x;
    };
    if (!is_farther(i - 1) || !is_farther(i + 1)) {
      line.push_back(place(crests[i]));
    }
  }
  if (rests) {
    line.push_back(place(*std::next(states.rbegin())));
  }
  line.push_back({place(states.back()).x, rests ? place(states.back()).y : line.back().y});
  return line;
}

bool is_drawn(const DrawnMotion& motion, const OtherMotion& other) {
  constexpr double crossing = 3;  // times the peak: beyond that it would only cross the figure
  return !other.if_comparable ||
         reach(other.states) <=
             std::max((is_long(other) ? farthest_shown : crossing) * reach(motion.states),
                      farthest_shown * motion.beta.value_or(0));
}

std::string name_of(const OtherMotion& other, const figures::FigureAxis& axis,
                    const FigureUnits& units) {
  const std::string name = other.name + (is_long(other) ? " (envelope)" : "");
  const auto [least, most] = extent(other.states, &State::x);
  const bool below = least * units.length < axis.least;
  const bool above = most * units.length > axis.most;
  const auto [low, high] = other.reach;
  return below || above ? format("{}, beyond the frame to {}", name,
                                 units.place_words(above && (!below || high > -low) ? high : low))
                        : name;
}

std::vector<std::vector<FigurePoint>> strokes_of(const OtherMotion& other, const Place& place) {
  if (!is_long(other)) {
    return {places(other.states, place)};
  }
  return {crest_line(other.states, other.turns, 1, false, place),
          crest_line(other.states, other.turns, -1, false, place)};
}

DrawnMotion::DrawnMotion(ShownMotion shown) : ShownMotion(std::move(shown)) {
  if (frictionless) {
    const bool slides = oscillator.f > 0 || !surface.zones.empty();
    others.push_back({.name = slides ? "without friction" : "without the notch",
                      .states = std::move(frictionless->states),
                      .reach = frictionless->reach,
                      .turns = std::move(frictionless->turns),
                      .if_comparable = true});
  }
}

void add_if_visible(DrawnMotion& motion, OtherMotion other) {
  double apart = 0;
  for (const State& state : motion.states) {
    apart = std::max(apart, std::abs(state.x - design::displacement(other.states, state.tau)));
  }
  constexpr double visible = 0.02;  // of the peak: a few pixels
  if (apart >= visible * reach(motion.states) && !is_long(motion)) {
    add(motion, std::move(other));
  }
}

void add(DrawnMotion& motion, OtherMotion other) {
  const double last = design::displacement(other.states, motion.shown_to);
  std::erase_if(other.states, [&](const State& state) { return state.tau > motion.shown_to; });
  other.states.push_back({motion.shown_to, last, 0});
  other.reach = extent(other.states, &State::x);
  motion.others.push_back(std::move(other));
}

}  // namespace stillpoint::report
