// SPDX-License-Identifier: MIT
#include "figures/report_figures.hpp"

#include <stillpoint/core/half_cycles.hpp>
#include <stillpoint/core/trajectory.hpp>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <iterator>
#include <numbers>
#include <utility>
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

/// The longest time that is drawn.
double longest_shown(double rate) {
  return most_drawn_periods * 2 * std::numbers::pi / rate;
}

/// From the least x to the largest of a motion without friction under all of a load that ends, and
/// after it, or up to `end`.
Interval reach_of(const ForcedTrajectory& path, const Excitation& excitation, double p,
                  double end) {
  Interval reach{0, 0};
  const auto include = [&](double x) { reach = {std::min(reach.low, x), std::max(reach.high, x)}; };
  include(path.at(0).x);
  for (const Event& event : path.events()) {
    include(event.state.x);
  }
  if (const double load = duration(excitation).value_or(HUGE_VAL); load <= end) {
    const State last = path.at(load);
    const double amplitude = std::hypot(last.x, last.v / p);
    include(amplitude);
    include(-amplitude);
  }
  return reach;
}

/// The same start without friction.
void add_frictionless(DrawnMotion& motion, const SimulationRequest& request) {
  const double p = request.oscillator.p;
  const double f = request.oscillator.f;
  const double rate = fastest_rate(p, request.excitation);
  const bool loses = f > 0 || request.oscillator.delta > 0 || !request.surface.zones.empty();
  if (!loses || motion.shown_to == 0 || motion.shown_to > longest_shown(rate)) {
    return;
  }
  const auto path_to = [&](double horizon) {
    ForcedTrajectoryOptions limits;
    limits.horizon = horizon;
    return ForcedTrajectory({p, 0, 0}, request.start, request.excitation, limits);
  };
  const ForcedTrajectory path = path_to(motion.shown_to);
  const bool slides = f > 0 || !request.surface.zones.empty();
  OtherMotion other{slides ? "without friction" : "without the notch",
                    path.sampled(sample_count(rate, motion.shown_to))};
  for (const Event& event : path.events()) {
    if (event.kind == EventKind::turn) {
      other.turns.push_back(event.state);
    }
  }
  other.if_comparable = true;
  const double load = duration(request.excitation).value_or(HUGE_VAL);
  const double end = std::min({load, request.t_end.value_or(load), longest_shown(rate)});
  other.reach = reach_of(end > motion.shown_to ? path_to(end) : path, request.excitation, p, end);
  motion.others.push_back(std::move(other));
}

/// The end of the figure for a motion that comes to rest: the whole load is shown, and of one that
/// goes on until `last` as much as leaves the motion large enough to be seen.
double seen_until(const Excitation& excitation, double stop_time, double last) {
  constexpr double seen_at_rest = 1.25;
  constexpr double most_at_rest = 10;
  const double load = duration(excitation).value_or(std::min(last, most_at_rest * stop_time));
  return std::max(seen_at_rest * stop_time, load);
}

void show_rest(DrawnMotion& motion, const State& rest, double until) {
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
void add_edges(DrawnMotion& motion, const ForcedTrajectory& path) {
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
void add_events(DrawnMotion& motion, const std::vector<Event>& events) {
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

/// A free motion with the paper's notch up to `horizon`; empty: to its end.
void follow_free(DrawnMotion& motion, const SimulationRequest& request,
                 const std::optional<double>& horizon) {
  const Trajectory path(request.oscillator, request.start, {.horizon = horizon});
  motion.states = path.sampled(sample_count(request.oscillator.p, path.horizon()));
  add_events(motion, path.events());
  motion.shown_to = path.horizon();
}

/// A forced motion up to `horizon`, or one on a surface of its own.
void follow_forced(DrawnMotion& motion, const SimulationRequest& request, double horizon) {
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

void draw_free(DrawnMotion& motion, const SimulationRequest& request) {
  const auto cut = end_of_beginning(
      first_half_cycles(request.oscillator, request.start, most_drawn_half_cycles));
  follow_free(motion, request, cut);
  motion.whole = !cut;
  if (motion.rest && motion.shown_to > 0) {
    show_rest(motion, *motion.rest, seen_until({}, motion.shown_to, motion.shown_to));
  }
}

void draw_forced(DrawnMotion& motion, const SimulationRequest& request, const Simulation& answer) {
  const Excitation& excitation = request.excitation;
  const auto& stop_time = answer.response.stop_time;
  const double rate = fastest_rate(request.oscillator.p, excitation);
  const double longest = longest_shown(rate);
  const double horizon = answer.horizon.value_or(longest);
  double last = std::min(horizon, longest);
  const auto listed = forced_half_cycles(request.oscillator, request.start, excitation, last,
                                         most_drawn_half_cycles, {}, request.surface);
  last = std::min(last, end_of_beginning(listed).value_or(last));
  const auto locked_from = answer.forced ? answer.forced->locked_from : std::nullopt;
  if (stop_time == 0.0) {  // the whole load is shown here too
    follow_forced(motion, request, std::min(last, duration(excitation).value_or(last)));
    motion.locked_from = locked_from;
    return;
  }
  const bool rest_is_seen = stop_time && last >= *stop_time;
  // At rest nothing changes: all samples go to what moves.
  follow_forced(motion, request, rest_is_seen ? *stop_time : last);
  if (rest_is_seen) {
    const State rest{*stop_time, *answer.response.stop_position, 0};
    if (rest.x == 0 && request.oscillator.delta > 0 && !request.surface.notch_width) {
      motion.states.push_back(rest);  // the notch stops it at once
    }
    show_rest(motion, rest, seen_until(excitation, *stop_time, last));
    motion.locked_from = locked_from;
    const double end = std::min(horizon, duration(excitation).value_or(horizon));
    if (locked_from && end > motion.shown_to) {
      motion.locked_to = end;
    }
  }
  motion.whole = last >= horizon || rest_is_seen;
}

/// Where a motion in states is at tau; after the last it rests.
double displacement(const std::vector<State>& states, double tau) {
  const auto next = std::ranges::lower_bound(states, tau, {}, &State::tau);
  if (next == states.begin() || next == states.end()) {
    return next == states.end() ? states.back().x : next->x;
  }
  const State& before = *std::prev(next);
  return before.x + (next->x - before.x) * (tau - before.tau) / (next->tau - before.tau);
}

}  // namespace

std::int64_t sample_count(double rate, double horizon) {
  constexpr double smoothness = 40;  // samples a period
  constexpr double fewest_samples = 400;
  constexpr double most_samples = smoothness * most_drawn_periods;
  const double periods = rate * horizon / (2 * std::numbers::pi);
  return static_cast<std::int64_t>(std::clamp(smoothness * periods, fewest_samples, most_samples));
}

DrawnMotion drawn_motion(const SimulationRequest& request, const Simulation& answer) {
  DrawnMotion motion;
  motion.oscillator = request.oscillator;
  motion.surface = request.surface;
  if (!is_forced(request) && answer.response.stop_time == 0.0) {
    motion.states = {{0, request.start.x0, 0}};  // held where it starts
    return motion;
  }
  if (!is_forced(request) && request.surface.plain()) {
    draw_free(motion, request);
  } else {
    draw_forced(motion, request, answer);
  }
  if (answer.response.stop_time != 0.0) {
    add_frictionless(motion, request);
  }
  return motion;
}

void add_if_visible(DrawnMotion& motion, OtherMotion other) {
  double apart = 0;
  double most = 0;
  for (const State& state : motion.states) {
    apart = std::max(apart, std::abs(state.x - displacement(other.states, state.tau)));
    most = std::max(most, std::abs(state.x));
  }
  constexpr double visible = 0.02;  // of the peak: a few pixels
  if (apart < visible * most || is_long(motion)) {
    return;
  }
  std::erase_if(other.states, [&](const State& state) { return state.tau > motion.shown_to; });
  other.states.push_back({motion.shown_to, displacement(other.states, motion.shown_to), 0});
  motion.others.push_back(std::move(other));
}

}  // namespace stillpoint::report
