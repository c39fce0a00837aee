// SPDX-License-Identifier: MIT
#include "figures/motion_figures.hpp"

#include <stillpoint/report/digits.hpp>

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <iterator>
#include <utility>

namespace stillpoint::report {

using figures::axis_around;
using figures::Dash;
using figures::Figure;
using figures::FigureCurve;
using figures::FigurePoint;
using figures::Ink;

namespace {

/// Whether all turns are equally far and there are more than two.
bool is_one_orbit(const DrawnMotion& motion) {
  constexpr double alike = 1e-9;
  const auto distance = [](const State& turn) { return std::abs(turn.x); };
  if (motion.turns.size() < 3) {
    return false;
  }
  const auto [least, most] = std::ranges::minmax(motion.turns, {}, distance);
  return distance(most) - distance(least) <= alike * distance(most);
}

/// From turn to turn but one of a motion with more than can be told apart, evenly spaced.
std::vector<Interval> some_loops(const DrawnMotion& motion) {
  const std::vector<State>& turns = motion.turns;
  const std::size_t step = 2 * (turns.size() / most_single_half_cycles + 1);
  std::vector<Interval> loops;
  for (std::size_t i = 0; i + 2 < turns.size(); i += step) {
    loops.push_back({turns[i].tau, turns[i + 2].tau});
  }
  return loops;
}

}  // namespace

Figure phase_figure(const DrawnMotion& motion, const FigureUnits& units) {
  const auto place = [&](const State& state) {
    return FigurePoint{state.x * units.length, state.v * units.velocity};
  };
  // Without friction a free motion only repeats its first two turns.
  const bool repeats = is_one_orbit(motion);
  const bool long_one = !repeats && is_long(motion);
  const double last = repeats ? motion.turns[2].tau : motion.states.back().tau;
  const std::vector<Interval> loops =
      long_one ? some_loops(motion) : std::vector<Interval>{{0, last}};
  const auto loop_of = [&](const State& state) {
    return std::ranges::find_if(loops, [&](const Interval& loop) {
      return loop.low <= state.tau && state.tau <= loop.high;
    });
  };
  std::vector<State> states = motion.states;
  std::erase_if(states, [&](const State& state) { return loop_of(state) == loops.end(); });
  const auto [x_least, x_most] = extent(states, &State::x);
  const auto [v_least, v_most] = extent(states, &State::v);
  FigureCurve arcs{.name = "motion", .strokes = {}, .ink = Ink::blue, .directed = true};
  FigureCurve jumps{"jump at x = 0", {}, Ink::orange, Dash::dotted, false};
  double largest_jump = 0;
  const State* before = nullptr;
  for (const State& state : states) {
    const bool jumped = before != nullptr && before->tau == state.tau && before->v != state.v;
    if (jumped) {
      jumps.strokes.push_back({place(*before), place(state)});
      largest_jump = std::max(largest_jump, std::abs(state.v - before->v));
    }
    const bool new_loop = before != nullptr && loop_of(*before) != loop_of(state);
    if (before == nullptr || jumped || new_loop) {
      arcs.strokes.emplace_back();
    }
    if (new_loop && before->tau == loop_of(state)->low) {
      arcs.strokes.back().push_back(place(*before));
    }
    arcs.strokes.back().push_back(place(state));
    before = &state;
  }
  Figure figure;
  figure.id = "phase";
  figure.title = "Phase portrait" + (long_one  ? " (some of the turns)"
                                     : repeats ? ""
                                               : beginning(motion));
  figure.x = axis_around(units.x_label, x_least * units.length, x_most * units.length);
  figure.y = axis_around(units.velocity_label, v_least * units.velocity, v_most * units.velocity);
  figure.description =
      fmt::format("Velocity over displacement, from x = {}, x' = {}.",
                  units.length.words(states.front().x), units.velocity.words(states.front().v));
  add_zones(figure, motion, units.length.factor, Along::y);
  figure.curves = {std::move(arcs)};
  constexpr double visible = 0.01;  // of the height, some pixels
  if (largest_jump > visible * (v_most - v_least)) {
    figure.clauses = {"At x = 0 the velocity jumps because the notch takes energy"};
    figure.curves.push_back(std::move(jumps));
  } else if (!jumps.strokes.empty()) {
    figure.clauses = {
        "The notch takes energy at x = 0, where the jump of the velocity is too small to see"};
  } else if (motion.surface.notch_width) {
    const State& start = states.front();
    figure.clauses = {fmt::format(
        "The notch takes energy over its width{}",
        start.x == 0 && start.v != 0 ? ", but none when the hit moves the mass out of it" : "")};
  } else {
    figure.clauses = {!motion.surface.zones.empty() ? "The curve bends where the friction changes"
                      : motion.rest && !long_one    ? "The curve ends where friction holds the mass"
                      : motion.oscillator.f > 0     ? "Friction takes energy along the whole curve"
                                                    : "Nothing takes energy from the mass"};
  }
  mark_events(figure, motion, place, long_one ? 0 : last);
  return figure;
}

}  // namespace stillpoint::report
