// SPDX-License-Identifier: MIT
#pragma once

#include <stillpoint/core/excitation.hpp>
#include <stillpoint/core/forced_event.hpp>
#include <stillpoint/core/oscillator.hpp>
#include <stillpoint/core/state.hpp>
#include <stillpoint/core/surface.hpp>

#include <cstdint>
#include <functional>
#include <memory>
#include <vector>

namespace stillpoint {

struct ForcedEvent {
  ForcedEventKind kind{ForcedEventKind::start};
  State state;
};

struct ForcedTrajectoryOptions {
  double horizon{0};               ///< the last tau; > 0
  std::int64_t pieces{2'000'000};  ///< at most; a motion with more throws InputError of t_end
  /// As in ForcedOptions; if it returns false, the trajectory ends there.
  std::function<bool(double)> go_on{};
  bool to_rest{false};  ///< ends at the final rest, if that is known by then and not at tau = 0
};

/// A forced motion with its state at any instant of [0, horizon] and its events in order of time.
/// It holds every piece: some 200 bytes for each turn, passage, rest or interval of a record.
class ForcedTrajectory {
 public:
  /// Throws InputError as forced_response does.
  ForcedTrajectory(const Oscillator& oscillator, const Start& start, const Excitation& excitation,
                   const ForcedTrajectoryOptions& limits, const Surface& surface = {});

  /// The state at tau; at an instant with two velocities the later one. Throws InputError outside
  /// [0, horizon].
  [[nodiscard]] State at(double tau) const;

  /// `samples` >= 2 evenly spaced instants of [0, horizon] and every event, in order of time.
  [[nodiscard]] std::vector<State> sampled(std::int64_t samples) const;

  [[nodiscard]] const std::vector<ForcedEvent>& events() const { return events_; }
  [[nodiscard]] double horizon() const { return horizon_; }

 private:
  class Pieces;
  class Watcher;

  double horizon_;
  std::vector<ForcedEvent> events_;
  std::shared_ptr<const Pieces> pieces_;
};

}  // namespace stillpoint
