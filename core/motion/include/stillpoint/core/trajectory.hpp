// SPDX-License-Identifier: MIT
#pragma once

#include <stillpoint/core/oscillator.hpp>
#include <stillpoint/core/state.hpp>

#include <Eigen/Core>

#include <cstdint>
#include <optional>
#include <string_view>
#include <vector>

namespace stillpoint {

enum class EventKind {
  start,
  turn,     ///< x' = 0 at a peak from which the motion goes on
  arrival,  ///< x = 0, with the speed before the notch
  passage,  ///< the same instant, with the speed after it
  rest,     ///< the end of the motion
};

/// The name in output: the enumerator's own.
[[nodiscard]] std::string_view name(EventKind kind) noexcept;

/// The enumerator of that name; empty where there is none.
[[nodiscard]] std::optional<EventKind> parse_event_kind(std::string_view name) noexcept;

struct Event {
  EventKind kind{EventKind::start};
  State state;
};

/// How much of a motion a Trajectory holds.
struct TrajectoryOptions {
  /// The last tau, > 0; empty: the end of the motion. A motion without friction has no end, so it
  /// needs one.
  std::optional<double> horizon;
  std::int64_t half_cycles{1'000'000};  ///< at most; a motion with more throws TooManyHalfCycles
};

/// The state of a free motion at any instant in [0, horizon], and its events in order of time.
/// Between events each arc continues from its own start, in a form that keeps the digits of a small
/// x where its centre is far away; at an event the state is that of the event. After the rest it
/// stays.
class Trajectory {
 public:
  /// Throws InputError as free_response does, for limits out of range, for a missing horizon where
  /// the motion never stops, and TooManyHalfCycles.
  Trajectory(const Oscillator& oscillator, const Start& start, const TrajectoryOptions& limits);

  /// The state at tau; at an instant with two velocities the later one. Throws InputError outside
  /// [0, horizon].
  [[nodiscard]] State at(double tau) const;

  /// Rows (tau, x, v), one for each entry of `tau`.
  [[nodiscard]] Eigen::ArrayX3d at(const Eigen::ArrayXd& tau) const;

  /// `samples` >= 2 evenly spaced instants of [0, horizon] and every event, in order of time.
  [[nodiscard]] std::vector<State> sampled(std::int64_t samples) const;

  [[nodiscard]] const std::vector<Event>& events() const { return events_; }
  /// The requested horizon, or the end of the motion; 0 if nothing moves.
  [[nodiscard]] double horizon() const { return horizon_; }

 private:
  struct Arc {
    double begin;
    double x;
    double v;
    double lever;  ///< x less the centre of the arc
  };

  class Builder;

  double p_;
  double horizon_;
  std::vector<Arc> arcs_;
  std::vector<Event> events_;
};

}  // namespace stillpoint
