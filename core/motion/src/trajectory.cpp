// SPDX-License-Identifier: MIT
#include "kernel/half_cycle_steps.hpp"

#include <stillpoint/core/elementary.hpp>
#include <stillpoint/core/input_error.hpp>
#include <stillpoint/core/trajectory.hpp>

#include <algorithm>
#include <cassert>
#include <cmath>
#include <cstddef>
#include <limits>
#include <utility>

namespace stillpoint {

namespace {

/// From one event of a free motion to the next.
struct Arc {
  double begin;
  double x;
  double v;
  double lever;  ///< x less the centre of the arc
};

State on_arc(const std::vector<Arc>& arcs, double p, double tau) {
  const Arc& arc = *std::prev(std::ranges::upper_bound(arcs, tau, {}, &Arc::begin));
  const double phase = p * (tau - arc.begin);
  const auto [sine, cosine] = elementary::sin_cos(phase);
  const double half_sine = elementary::sin_cos(phase / 2).sine;
  return {tau, arc.x + arc.v / p * sine - 2 * arc.lever * (half_sine * half_sine),
          arc.v * cosine - p * arc.lever * sine};
}

/// Takes the half-cycles of a walk one by one.
class FreePath {
 public:
  FreePath(const Oscillator& oscillator, const Start& start)
      : p_(oscillator.p), walk_(oscillator, start) {
    add_event(EventKind::start, 0, start.x0, moves() ? start.v0 : 0);
  }

  [[nodiscard]] Path found(const TrajectoryOptions& options) {
    if (options.horizon) {
      require_within("horizon", *options.horizon, std::numeric_limits<double>::min(),
                     std::numeric_limits<double>::max());
    } else if (moves() && walk_.map().without_friction()) {
      throw InputError::missing("horizon", "without friction the motion never ends");
    }
    double reached = 0;
    while (!options.horizon || reached < *options.horizon) {
      const std::optional<HalfCycle> next = walk_.next();
      if (!next) {
        break;
      }
      if (next->index > options.half_cycles) {
        throw TooManyHalfCycles::in_trajectory(static_cast<double>(options.half_cycles));
      }
      add(*next);
      reached = next->end_time;
    }
    const double horizon = options.horizon.value_or(reached);
    std::erase_if(events_, [&](const Event& event) { return event.state.tau > horizon; });
    std::function<State(double)> between;
    if (moves()) {
      between = [arcs = std::move(arcs_), p = p_](double tau) { return on_arc(arcs, p, tau); };
    }
    return {horizon, std::move(events_), std::move(between)};
  }

 private:
  [[nodiscard]] bool moves() const {
    return walk_.leg().end != FirstLegEnd::no_motion && walk_.leg().end != FirstLegEnd::caught;
  }

  void add(const HalfCycle& now) {
    const double side = now.side;
    const double shift = walk_.map().phi / p_;
    const bool inward = now.index == 1 && walk_.leg().end != FirstLegEnd::peak;
    if (inward) {
      arcs_.push_back({now.start_time, side * now.peak, -side * now.departure_speed,
                       side * (now.peak - shift)});
    } else {
      const double from = now.index == 1 ? walk_.leg().distance / p_ : 0;
      arcs_.push_back(
          {now.start_time, side * from, side * now.departure_speed, side * (from + shift)});
      if (now.end_time > now.peak_time) {
        arcs_.push_back({now.peak_time, side * now.peak, 0, side * (now.peak - shift)});
        add_event(EventKind::turn, now.peak_time, side * now.peak, 0);
      }
    }
    if (now.arrival_speed) {
      add_event(EventKind::arrival, now.end_time, 0, -side * *now.arrival_speed);
    }
    if (now.last) {
      add_event(EventKind::rest, now.end_time, now.end_position, 0);
    } else {
      add_event(EventKind::passage, now.end_time, 0, -side * walk_.next_departure_speed());
    }
  }

  void add_event(EventKind kind, double tau, double x, double v) {
    events_.push_back({kind, {tau, x, v}});
  }

  double p_;
  HalfCycleSteps walk_;
  std::vector<Arc> arcs_;
  std::vector<Event> events_;
};

}  // namespace

Path::Path(double horizon, std::vector<Event> events, std::function<State(double)> between)
    : horizon_(horizon), events_(std::move(events)), between_(std::move(between)) {}

State Path::at(double tau) const {
  require_within("tau", tau, 0, horizon_);
  const auto after = std::ranges::upper_bound(events_, tau, {},
                                              [](const Event& event) { return event.state.tau; });
  assert(after != events_.begin());
  const Event& before = *std::prev(after);
  if (before.state.tau == tau || before.kind == EventKind::rest || !between_) {
    return {tau, before.state.x, before.state.v};
  }
  return between_(tau);
}

std::vector<State> Path::sampled(std::int64_t samples) const {
  require_within("samples", static_cast<double>(samples), 2, 1e9);
  std::vector<State> states;
  states.reserve(static_cast<std::size_t>(samples) + events_.size());
  auto event = events_.begin();
  const std::int64_t instants = horizon_ == 0 ? 1 : samples;
  for (std::int64_t i = 0; i < instants; ++i) {
    const double fraction = static_cast<double>(i) / static_cast<double>(samples - 1);
    const double tau = horizon_ * fraction;
    bool on_event = false;
    for (; event != events_.end() && event->state.tau <= tau; ++event) {
      on_event = event->state.tau == tau;
      states.push_back(event->state);
    }
    if (!on_event) {
      states.push_back(at(tau));
    }
  }
  return states;
}

Trajectory::Trajectory(const Oscillator& oscillator, const Start& start,
                       const TrajectoryOptions& options)
    : Path(FreePath(oscillator, start).found(options)) {}

}  // namespace stillpoint
