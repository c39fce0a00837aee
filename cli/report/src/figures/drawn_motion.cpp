// SPDX-License-Identifier: MIT
#include "figures/report_figures.hpp"

#include <stillpoint/core/half_cycles.hpp>
#include <stillpoint/core/trajectory.hpp>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <numbers>
#include <variant>

namespace stillpoint::report {

namespace {

/// The fastest that the motion can swing: p, or the excitation's lambda.
double fastest_rate(double p, const Excitation& excitation) {
  const auto lambda = [](const auto& wave) {
    if constexpr (requires { wave.lambda; }) {
      return wave.lambda;
    } else {
      return 0.0;
    }
  };
  return std::max(p, std::visit(lambda, excitation));
}

/// The end of the last half-cycle that is drawn; empty: all of them are.
std::optional<double> end_of_beginning(const std::vector<HalfCycle>& listed) {
  return listed.size() < static_cast<std::size_t>(most_drawn_half_cycles)
             ? std::nullopt
             : std::optional(listed.back().end_time);
}

/// The same start without friction, if that has few half-cycles and a similar size.
std::vector<State> frictionless(const DrawnMotion& motion, const Start& start,
                                const Excitation& excitation) {
  if (motion.turns.size() > most_single_half_cycles || motion.oscillator.p == 0) {
    return {};
  }
  ForcedTrajectoryOptions limits;
  limits.horizon = motion.shown_to;
  const double rate = fastest_rate(motion.oscillator.p, excitation);
  const ForcedTrajectory path({motion.oscillator.p, 0, 0}, start, excitation, limits);
  const auto turns = static_cast<std::size_t>(std::ranges::count(
      path.events(), EventKind::turn, [](const Event& event) { return event.kind; }));
  if (turns > most_single_half_cycles) {
    return {};
  }
  std::vector<State> states = path.sampled(sample_count(rate, motion.shown_to));
  const auto largest = [](const std::vector<State>& all) {
    double most = 0;
    for (const State& state : all) {
      most = std::max(most, std::abs(state.x));
    }
    return most;
  };
  constexpr double comparable = 3;  // beyond that it would only cross the figure
  return largest(states) <= comparable * largest(motion.states) ? states : std::vector<State>{};
}

/// The end of the figure for a motion that comes to rest: the whole load is shown.
double seen_until(const Excitation& excitation, double stop_time) {
  constexpr double seen_at_rest = 1.25;
  return std::max(seen_at_rest * stop_time, duration(excitation).value_or(0));
}

void show_rest(DrawnMotion& motion, const State& rest, double until) {
  motion.rest = rest;
  motion.states.push_back({until, rest.x, 0});
  motion.shown_to = until;
}

/// Of a mass that is held where it starts, with no load that could move it.
DrawnMotion no_motion(const Oscillator& oscillator, const Start& start) {
  DrawnMotion motion;
  motion.oscillator = oscillator;
  motion.states = {{0, start.x0, 0}};
  return motion;
}

}  // namespace

std::int64_t sample_count(double rate, double horizon) {
  constexpr double smoothness = 40;  // samples a period
  constexpr double fewest_samples = 400;
  constexpr double most_samples = smoothness * most_drawn_periods;
  const double periods = rate * horizon / (2 * std::numbers::pi);
  return static_cast<std::int64_t>(std::clamp(smoothness * periods, fewest_samples, most_samples));
}

DrawnMotion drawn_free_motion(const Oscillator& oscillator, const Start& start,
                              const std::optional<double>& horizon) {
  const Trajectory path(oscillator, start, {.horizon = horizon});
  DrawnMotion motion;
  motion.oscillator = oscillator;
  motion.states = path.sampled(sample_count(oscillator.p, path.horizon()));
  for (const Event& event : path.events()) {
    if (event.kind == EventKind::turn) {
      motion.turns.push_back(event.state);
    } else if (event.kind == EventKind::passage) {
      motion.passages.push_back(event.state);
    } else if (event.kind == EventKind::rest) {
      motion.rest = event.state;
    }
  }
  motion.shown_to = motion.states.back().tau;
  if (motion.rest && motion.shown_to > 0) {
    show_rest(motion, *motion.rest, seen_until({}, motion.shown_to));
  }
  if (motion.shown_to > 0) {
    motion.frictionless = frictionless(motion, start, {});
  }
  return motion;
}

DrawnMotion drawn_forced_motion(const Oscillator& oscillator, const Start& start,
                                const Excitation& excitation, double horizon,
                                const Surface& surface) {
  ForcedTrajectoryOptions limits;
  limits.horizon = horizon;
  const ForcedTrajectory path(oscillator, start, excitation, limits, surface);
  DrawnMotion motion;
  motion.oscillator = oscillator;
  motion.states =
      path.sampled(sample_count(fastest_rate(oscillator.p, excitation), path.horizon()));
  bool held = false;
  double held_since = 0;
  for (const Event& event : path.events()) {
    using enum EventKind;
    if (event.kind == turn) {
      motion.turns.push_back(event.state);
    } else if (event.kind == passage) {
      motion.passages.push_back(event.state);
    } else if (event.kind == rest) {
      motion.rest = event.state;
    } else if (event.kind == stick) {
      held = true;
      held_since = event.state.tau;
    }
    if (held && (event.kind == release || event.kind == end || event.kind == rest)) {
      if (event.state.tau > held_since) {
        motion.sticks.emplace_back(held_since, event.state.tau);
      }
      held = false;
    }
  }
  motion.shown_to = horizon;
  return motion;
}

DrawnMotion drawn_motion(const SimulationRequest& request, const Simulation& answer) {
  const Oscillator& oscillator = request.oscillator;
  const Start& start = request.start;
  const Excitation& excitation = request.excitation;
  const Surface& surface = request.surface;
  if (!is_forced(request) && surface.plain()) {
    const auto cut = end_of_beginning(first_half_cycles(oscillator, start, most_drawn_half_cycles));
    DrawnMotion motion = drawn_free_motion(oscillator, start, cut);
    motion.whole = !cut;
    return motion;
  }
  const auto& stop_time = answer.response.stop_time;
  if (stop_time == 0.0 && !is_forced(request)) {
    return no_motion(oscillator, start);
  }
  const double rate = fastest_rate(oscillator.p, excitation);
  const double longest = most_drawn_periods * 2 * std::numbers::pi / rate;
  const double horizon = answer.horizon.value_or(longest);
  double last = std::min(horizon, longest);
  const auto listed =
      forced_half_cycles(oscillator, start, excitation, last, most_drawn_half_cycles, {}, surface);
  last = std::min(last, end_of_beginning(listed).value_or(last));
  if (stop_time == 0.0) {  // the whole load is shown here too
    last = std::min(last, duration(excitation).value_or(last));
    DrawnMotion motion = drawn_forced_motion(oscillator, start, excitation, last, surface);
    motion.locked_from = answer.forced ? answer.forced->locked_from : std::nullopt;
    return motion;
  }
  const bool rest_is_seen = stop_time && last >= *stop_time;
  // At rest nothing changes: all samples go to what moves.
  DrawnMotion motion =
      drawn_forced_motion(oscillator, start, excitation, rest_is_seen ? *stop_time : last, surface);
  if (rest_is_seen) {
    const State rest{*stop_time, *answer.response.stop_position, 0};
    if (rest.x == 0 && oscillator.delta > 0 && !surface.notch_width) {
      motion.states.push_back(rest);  // the notch stops it at once
    }
    show_rest(motion, rest, seen_until(excitation, *stop_time));
    motion.locked_from = answer.forced ? answer.forced->locked_from : std::nullopt;
  }
  if (motion.shown_to > 0) {
    motion.frictionless = frictionless(motion, start, excitation);
  }
  motion.whole = last >= horizon || rest_is_seen;
  return motion;
}

}  // namespace stillpoint::report
