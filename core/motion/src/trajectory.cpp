// SPDX-License-Identifier: MIT
#include "kernel/half_cycle_steps.hpp"
#include "sampling.hpp"

#include <stillpoint/core/elementary.hpp>
#include <stillpoint/core/input_error.hpp>
#include <stillpoint/core/trajectory.hpp>

#include <algorithm>
#include <cassert>
#include <cmath>
#include <limits>

namespace stillpoint {

/// Takes the half-cycles of a walk one by one.
class Trajectory::Builder {
 public:
  Builder(Trajectory& path, const HalfCycleSteps& walk) : path_(path), walk_(walk) {}

  void add(const HalfCycle& now) {
    const double side = now.side;
    const double shift = walk_.map().phi / path_.p_;
    const bool inward = now.index == 1 && walk_.leg().end != FirstLegEnd::peak;
    if (inward) {
      path_.arcs_.push_back({now.start_time, side * now.peak, -side * now.departure_speed,
                             side * (now.peak - shift)});
    } else {
      const double from = now.index == 1 ? walk_.leg().distance / path_.p_ : 0;
      path_.arcs_.push_back(
          {now.start_time, side * from, side * now.departure_speed, side * (from + shift)});
      if (now.end_time > now.peak_time) {
        path_.arcs_.push_back({now.peak_time, side * now.peak, 0, side * (now.peak - shift)});
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
    path_.events_.push_back({kind, {tau, x, v}});
  }

 private:
  Trajectory& path_;
  const HalfCycleSteps& walk_;
};

Trajectory::Trajectory(const Oscillator& oscillator, const Start& start,
                       const TrajectoryOptions& options)
    : p_(oscillator.p), horizon_(options.horizon.value_or(0)) {
  if (options.horizon) {
    require_within("horizon", *options.horizon, std::numeric_limits<double>::min(),
                   std::numeric_limits<double>::max());
  }
  HalfCycleSteps walk(oscillator, start);
  const bool moves =
      walk.leg().end != FirstLegEnd::no_motion && walk.leg().end != FirstLegEnd::caught;
  if (!options.horizon && moves && walk.map().without_friction()) {
    throw InputError::missing("horizon", "without friction the motion never ends");
  }
  Builder builder(*this, walk);
  builder.add_event(EventKind::start, 0, start.x0, moves ? start.v0 : 0);
  double reached = 0;
  while (!options.horizon || reached < horizon_) {
    const std::optional<HalfCycle> next = walk.next();
    if (!next) {
      break;
    }
    if (next->index > options.half_cycles) {
      throw TooManyHalfCycles::in_trajectory(static_cast<double>(options.half_cycles));
    }
    builder.add(*next);
    reached = next->end_time;
  }
  if (!options.horizon) {
    horizon_ = reached;
  }
  const auto past = [this](const auto& item) { return item.state.tau > horizon_; };
  std::erase_if(events_, past);
}

State Trajectory::at(double tau) const {
  require_within("tau", tau, 0, horizon_);
  const auto after = std::ranges::upper_bound(events_, tau, {},
                                              [](const Event& event) { return event.state.tau; });
  assert(after != events_.begin());
  const Event& before = *std::prev(after);
  if (before.state.tau == tau || before.kind == EventKind::rest || arcs_.empty()) {
    return {tau, before.state.x, before.state.v};
  }
  const Arc& arc = *std::prev(std::ranges::upper_bound(arcs_, tau, {}, &Arc::begin));
  const double phase = p_ * (tau - arc.begin);
  const auto [sine, cosine] = elementary::sin_cos(phase);
  const double half_sine = elementary::sin_cos(phase / 2).sine;
  return {tau, arc.x + arc.v / p_ * sine - 2 * arc.lever * (half_sine * half_sine),
          arc.v * cosine - p_ * arc.lever * sine};
}

std::vector<State> Trajectory::sampled(std::int64_t samples) const {
  return sampled_states(*this, samples);
}

}  // namespace stillpoint
