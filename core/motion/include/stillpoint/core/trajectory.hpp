// SPDX-License-Identifier: MIT
#pragma once

#include <stillpoint/core/excitation.hpp>
#include <stillpoint/core/oscillator.hpp>
#include <stillpoint/core/state.hpp>
#include <stillpoint/core/surface.hpp>

#include <cstdint>
#include <functional>
#include <optional>
#include <vector>

namespace stillpoint {

/// The state of a motion at any instant in [0, horizon], and its events in order of time. After the
/// final rest it stays.
class Path {
 public:
  /// `between`: the state at a tau between two events; not needed of a mass that never moves.
  Path(double horizon, std::vector<Event> events, std::function<State(double)> between);

  /// The state at tau; at an instant with two velocities the later one. Throws InputError outside
  /// [0, horizon].
  [[nodiscard]] State at(double tau) const;

  /// `samples` >= 2 evenly spaced instants of [0, horizon] and every event, in order of time; only
  /// the events if the horizon is 0. An event that falls on an instant replaces it.
  [[nodiscard]] std::vector<State> sampled(std::int64_t samples) const;

  [[nodiscard]] const std::vector<Event>& events() const { return events_; }
  [[nodiscard]] double horizon() const { return horizon_; }

 private:
  double horizon_;
  std::vector<Event> events_;
  std::function<State(double)> between_;
};

/// How much of a motion a Trajectory holds.
struct TrajectoryOptions {
  /// The last tau, > 0; empty: the end of the motion. A motion without friction has no end, so it
  /// needs one.
  std::optional<double> horizon;
  std::int64_t half_cycles{1'000'000};  ///< at most; a motion with more throws TooManyHalfCycles
};

/// A free motion, to the requested horizon or its end; to 0 if nothing moves. Between events each
/// arc continues from its own start, in a form that keeps the digits of a small x where its centre
/// is far away; at an event the state is that of the event.
class Trajectory : public Path {
 public:
  /// Throws InputError as free_response does, for options out of range, for a missing horizon where
  /// the motion never stops, and TooManyHalfCycles.
  Trajectory(const Oscillator& oscillator, const Start& start, const TrajectoryOptions& options);
};

struct ForcedTrajectoryOptions {
  double horizon{0};               ///< the last tau; > 0
  std::int64_t pieces{2'000'000};  ///< at most; a motion with more throws InputError of t_end
  /// As in ForcedOptions; if it returns false, the trajectory ends there.
  std::function<bool(double)> go_on{};
  bool to_rest{false};  ///< ends at the final rest, if that is known by then and not at tau = 0
};

/// A forced motion. It holds every piece: about 200 bytes for each turn, passage, rest or interval
/// of a record.
class ForcedTrajectory : public Path {
 public:
  /// Throws InputError as forced_response does.
  ForcedTrajectory(const Oscillator& oscillator, const Start& start, const Excitation& excitation,
                   const ForcedTrajectoryOptions& options, const Surface& surface = {});
};

}  // namespace stillpoint
