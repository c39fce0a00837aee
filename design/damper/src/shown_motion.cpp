// SPDX-License-Identifier: MIT
#include <stillpoint/core/elementary.hpp>
#include <stillpoint/core/half_cycles.hpp>
#include <stillpoint/core/trajectory.hpp>
#include <stillpoint/design/figures.hpp>
#include <stillpoint/design/shown_motion.hpp>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <iterator>
#include <numbers>
#include <variant>

namespace stillpoint::design {

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
  return listed.size() < static_cast<std::size_t>(most_shown_half_cycles)
             ? std::nullopt
             : std::optional(listed.back().end_time);
}

/// The longest time that is drawn.
double longest_shown(double rate) {
  return most_shown_periods * 2 * std::numbers::pi / rate;
}

/// From the least x to the largest on the path of a motion without friction; without damping also
/// after it, if the load is over by `end`.
Interval reach_of(const ForcedTrajectory& path, const Excitation& excitation,
                  const Oscillator& linear, double end) {
  Interval reach{0, 0};
  const auto include = [&](double x) { reach = {std::min(reach.low, x), std::max(reach.high, x)}; };
  include(path.at(0).x);
  for (const Event& event : path.events()) {
    include(event.state.x);
  }
  const double load = duration(excitation).value_or(HUGE_VAL);
  if (load <= end && linear.zeta == 0) {
    const State last = path.at(load);
    const double amplitude = elementary::hypot(last.x, last.v / linear.p);
    include(amplitude);
    include(-amplitude);
  }
  return reach;
}

/// The same start without friction.
void add_frictionless(ShownMotion& motion, const SimulationRequest& request) {
  const Oscillator linear{.p = request.oscillator.p, .zeta = request.oscillator.zeta};
  const double rate = fastest_rate(linear.p, request.excitation);
  const bool loses =
      request.oscillator.f > 0 || request.oscillator.delta > 0 || !request.surface.zones.empty();
  if (!loses || motion.shown_to == 0 || motion.shown_to > longest_shown(rate)) {
    return;
  }
  const auto path_to = [&](double horizon) {
    ForcedTrajectoryOptions limits;
    limits.horizon = horizon;
    return ForcedTrajectory(linear, request.start, request.excitation, limits);
  };
  const ForcedTrajectory path = path_to(motion.shown_to);
  OtherMotion& other = motion.frictionless.emplace();
  other.states = path.sampled(sample_count(rate, motion.shown_to));
  for (const Event& event : path.events()) {
    if (event.kind == EventKind::turn) {
      other.turns.push_back(event.state);
    }
  }
  const double load = duration(request.excitation).value_or(HUGE_VAL);
  const double end = std::min({load, request.t_end.value_or(load), longest_shown(rate)});
  // A damped one swings farthest within a period of the load's end.
  const double after = linear.zeta > 0 && load <= end ? 2 * std::numbers::pi / linear.p : 0;
  other.reach = reach_of(end + after > motion.shown_to ? path_to(end + after) : path,
                         request.excitation, linear, end);
}

/// The end of the figure for a motion that comes to rest: the whole load is shown, and of one that
/// goes on until `last` as much as leaves the motion large enough to be seen.
double seen_until(const Excitation& excitation, double stop_time, double last) {
  constexpr double seen_at_rest = 1.25;
  constexpr double most_at_rest = 10;
  const double load = duration(excitation).value_or(std::min(last, most_at_rest * stop_time));
  return std::max(seen_at_rest * stop_time, load);
}

void add_rest(ShownMotion& motion, const State& rest, double until) {
  if (rest.x == 0 && motion.oscillator.delta > 0 && !motion.surface.notch_width) {
    motion.states.push_back(rest);  // the notch stops it at once
  }
  motion.rest = rest;
  motion.states.push_back({until, rest.x, 0});
  motion.shown_to = until;
}

/// The state at which x, which is monotone from one sample to the next, is at an edge.
State at_edge(const ForcedTrajectory& path, const State& from, const State& to, double edge) {
  constexpr int halvings = 50;
  double before = from.tau;
  double after = to.tau;
  for (int i = 0; i < halvings; ++i) {
    const double middle = (before + after) / 2;
    ((path.at(middle).x < edge) == (from.x < edge) ? before : after) = middle;
  }
  return {after, edge, path.at(after).v};
}

/// The samples of a motion with the states at the edges of its zones, where the friction changes.
void add_edges(ShownMotion& motion, const ForcedTrajectory& path) {
  std::vector<double> edges{motion.surface.notch_width.value_or(0) / 2};
  for (const FrictionZone& zone : motion.surface.zones) {
    edges.push_back(zone.to);
  }
  std::vector<State> states{motion.states.front()};
  for (const State& now : motion.states) {
    const State before = states.back();
    const auto first = static_cast<std::ptrdiff_t>(states.size());
    for (const double edge : edges) {
      for (const double side : {-edge, edge}) {
        if (edge > 0 && (before.x - side) * (now.x - side) < 0) {
          states.push_back(at_edge(path, before, now, side));
        }
      }
    }
    std::ranges::sort(states.begin() + first, states.end(), {}, &State::tau);
    states.push_back(now);
  }
  motion.states = std::move(states);
}

/// What happens on a path.
void add_events(ShownMotion& motion, const std::vector<Event>& events) {
  std::optional<double> held_since;
  for (const Event& event : events) {
    using enum EventKind;
    const double tau = event.state.tau;
    if (event.kind == turn) {
      motion.turns.push_back(event.state);
    } else if (event.kind == passage) {
      motion.passages.push_back(event.state);
    } else if (event.kind == rest) {
      motion.rest = event.state;
    }
    if (held_since && (event.kind == release || event.kind == end || event.kind == rest)) {
      if (tau > *held_since) {
        motion.sticks.emplace_back(*held_since, tau);
      }
      held_since.reset();
    } else if (event.kind == stick) {
      held_since = tau;
    }
  }
}

/// Up to `horizon`.
void follow(ShownMotion& motion, const SimulationRequest& request, double horizon) {
  ForcedTrajectoryOptions limits;
  limits.horizon = horizon;
  const ForcedTrajectory path(request.oscillator, request.start, request.excitation, limits,
                              request.surface);
  const double rate = fastest_rate(request.oscillator.p, request.excitation);
  motion.states = path.sampled(sample_count(rate, path.horizon()));
  add_events(motion, path.events());
  if (!request.surface.plain()) {
    add_edges(motion, path);
  }
  motion.shown_to = horizon;
}

}  // namespace

bool ShownMotion::moves() const {
  return std::ranges::any_of(states,
                             [](const State& state) { return state.tau > 0 && state.v != 0; });
}

bool is_as_far(const State& one, const State& other) {
  constexpr double rounding = 1 - 1e-12;
  return std::abs(one.x) >= std::abs(other.x) * rounding;
}

const State& ShownMotion::farthest() const {
  const State& most =
      *std::ranges::max_element(states, {}, [](const State& state) { return std::abs(state.x); });
  return *std::ranges::find_if(states, [&](const State& at) { return is_as_far(at, most); });
}

std::int64_t sample_count(double rate, double horizon) {
  constexpr double smoothness = 40;  // samples a period
  constexpr double fewest_samples = 400;
  constexpr double most_samples = smoothness * most_shown_periods;
  const double periods = rate * horizon / (2 * std::numbers::pi);
  return static_cast<std::int64_t>(std::clamp(smoothness * periods, fewest_samples, most_samples));
}

ShownMotion shown_motion(const SimulationRequest& request, const Simulation& answer) {
  ShownMotion motion;
  motion.oscillator = request.oscillator;
  motion.surface = request.surface;
  const Excitation& excitation = request.excitation;
  const auto& stop_time = answer.response.stop_time;
  if (!is_forced(request) && stop_time == 0.0) {
    motion.states = {{0, request.start.x0, 0}};  // held where it starts
    return motion;
  }
  const double longest = longest_shown(fastest_rate(request.oscillator.p, excitation));
  const double horizon = answer.horizon.value_or(longest);
  double last = std::min(horizon, longest);
  const auto listed = forced_half_cycles(request.oscillator, request.start, excitation, last,
                                         most_shown_half_cycles, {}, request.surface);
  last = std::min(last, end_of_beginning(listed).value_or(last));
  if (answer.forced) {
    motion.locked = figures_of(*answer.forced).locked;
  }
  if (stop_time == 0.0) {  // the whole load is shown here too
    follow(motion, request, std::min(last, duration(excitation).value_or(last)));
    return motion;
  }
  const bool rest_is_seen = stop_time && last >= *stop_time;
  // At rest nothing changes: all samples go to what moves.
  follow(motion, request, rest_is_seen ? *stop_time : last);
  motion.whole = rest_is_seen || (answer.horizon && last >= horizon);
  if (rest_is_seen) {
    add_rest(motion, {*stop_time, *answer.response.stop_position, 0},
             seen_until(excitation, *stop_time, last));
    const double end = std::min(horizon, duration(excitation).value_or(horizon));
    if (motion.locked && end > motion.shown_to) {
      motion.locked_to = end;
    }
  } else {
    motion.locked.reset();
  }
  add_frictionless(motion, request);
  return motion;
}

ShownMotion shown_motion(const SimulationRequest& request) {
  SimulationRequest response = request;
  response.energies = false;
  response.max_half_cycles = 0;
  return shown_motion(request, simulate(response));
}

}  // namespace stillpoint::design
