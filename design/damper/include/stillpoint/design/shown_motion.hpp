// SPDX-License-Identifier: MIT
#pragma once

// A motion sampled so that it can be drawn.

#include <stillpoint/core/interval.hpp>
#include <stillpoint/core/simulation.hpp>
#include <stillpoint/core/state.hpp>

#include <cstdint>
#include <optional>
#include <utility>
#include <vector>

namespace stillpoint::design {

/// Another motion from the same start, to compare with.
struct OtherMotion {
  std::vector<State> states;
  std::vector<State> turns;  ///< of one that may be drawn as its envelope
  Interval reach;            ///< of x, also beyond what is shown
};

struct ShownMotion {
  Oscillator oscillator;
  Surface surface;
  std::vector<State> states;    ///< samples, edges and events; a passage has two at one instant
  std::vector<State> turns;     ///< peaks
  std::vector<State> passages;  ///< of x = 0, with the speed after the notch
  std::optional<State> rest;    ///< the end of the motion
  std::vector<std::pair<double, double>> sticks;  ///< tau from, to
  std::optional<double> locked;             ///< held at x = 0 from then on, though the load goes on
  std::optional<double> locked_to;          ///< the end of the load, if it is not shown
  double shown_to{0};                       ///< the end of the time axis
  bool whole{true};                         ///< else only its beginning
  std::optional<OtherMotion> frictionless;  ///< if friction takes energy

  /// Whether it moves at all: a load may be too weak.
  [[nodiscard]] bool moves() const;
  /// The first of the farthest states.
  [[nodiscard]] const State& farthest() const;
};
/// But for rounding: what rests at its peak may be shown a last digit farther out later on.
[[nodiscard]] bool is_as_far(const State& one, const State& other);

/// For a longer motion only the beginning is shown: this many half-cycles, and periods of the
/// spring or of the load, whichever is faster.
inline constexpr std::int64_t most_shown_half_cycles = 2000;
inline constexpr double most_shown_periods = 1000;

/// The motion of an answer, or its beginning.
[[nodiscard]] ShownMotion shown_motion(const SimulationRequest& request, const Simulation& answer);
[[nodiscard]] ShownMotion shown_motion(const SimulationRequest& request);

/// Evenly spaced points that make a curve of an angular frequency look smooth up to tau =
/// `horizon`.
[[nodiscard]] std::int64_t sample_count(double rate, double horizon);

}  // namespace stillpoint::design
