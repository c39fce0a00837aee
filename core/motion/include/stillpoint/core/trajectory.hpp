// SPDX-License-Identifier: MIT
#pragma once

#include <stillpoint/core/excitation.hpp>
#include <stillpoint/core/oscillator.hpp>
#include <stillpoint/core/state.hpp>
#include <stillpoint/core/surface.hpp>

#include <cstdint>
#include <functional>
#include <memory>
#include <optional>
#include <vector>

namespace stillpoint {

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
  /// Throws InputError as free_response does, for options out of range, for a missing horizon where
  /// the motion never stops, and TooManyHalfCycles.
  Trajectory(const Oscillator& oscillator, const Start& start, const TrajectoryOptions& options);

  /// The state at tau; at an instant with two velocities the later one. Throws InputError outside
  /// [0, horizon].
  [[nodiscard]] State at(double tau) const;

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

struct ForcedTrajectoryOptions {
  double horizon{0};               ///< the last tau; > 0
  std::int64_t pieces{2'000'000};  ///< at most; a motion with more throws InputError of t_end
  /// As in ForcedOptions; if it returns false, the trajectory ends there.
  std::function<bool(double)> go_on{};
  bool to_rest{false};  ///< ends at the final rest, if that is known by then and not at tau = 0
};

/// A forced motion with its state at any instant of [0, horizon] and its events in order of time.
/// It holds every piece: about 200 bytes for each turn, passage, rest or interval of a record.
class ForcedTrajectory {
 public:
  /// Throws InputError as forced_response does.
  ForcedTrajectory(const Oscillator& oscillator, const Start& start, const Excitation& excitation,
                   const ForcedTrajectoryOptions& options, const Surface& surface = {});

  /// The state at tau; at an instant with two velocities the later one. Throws InputError outside
  /// [0, horizon].
  [[nodiscard]] State at(double tau) const;

  /// `samples` >= 2 evenly spaced instants of [0, horizon] and every event, in order of time.
  [[nodiscard]] std::vector<State> sampled(std::int64_t samples) const;

  [[nodiscard]] const std::vector<Event>& events() const { return events_; }
  [[nodiscard]] double horizon() const { return horizon_; }

 private:
  friend class PathWatcher;
  class Pieces;

  ForcedTrajectory() = default;

  double horizon_{0};
  std::vector<Event> events_;
  std::shared_ptr<const Pieces> pieces_;
};

}  // namespace stillpoint
