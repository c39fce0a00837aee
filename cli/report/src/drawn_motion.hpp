// SPDX-License-Identifier: MIT
#pragma once

#include <stillpoint/core/simulation.hpp>
#include <stillpoint/core/state.hpp>

#include <cstdint>
#include <optional>
#include <utility>
#include <vector>

namespace stillpoint::report {

/// A motion as its figures need it.
struct DrawnMotion {
  Oscillator oscillator;
  std::vector<State> states;    ///< samples and every event; a passage has two at one instant
  std::vector<State> turns;     ///< peaks
  std::vector<State> passages;  ///< of x = 0, with the speed after the notch
  std::optional<State> rest;    ///< the end of the motion
  std::vector<std::pair<double, double>> sticks;  ///< tau from, to
  std::optional<double> beta;
  bool whole{true};  ///< else only its beginning
};

/// Of a longer motion only the beginning is drawn: so many half-cycles, and periods of the spring
/// or of the load, whichever is faster.
inline constexpr std::int64_t most_drawn_half_cycles = 200;
inline constexpr double most_drawn_periods = 100;

/// Evenly spaced points that make a curve of an angular frequency look smooth up to tau =
/// `horizon`.
[[nodiscard]] std::int64_t sample_count(double rate, double horizon);

/// A free motion up to `horizon`; empty: to its end.
[[nodiscard]] DrawnMotion drawn_free_motion(const Oscillator& oscillator, const Start& start,
                                            const std::optional<double>& horizon);
/// A forced one up to `horizon`.
[[nodiscard]] DrawnMotion drawn_forced_motion(const Oscillator& oscillator, const Start& start,
                                              const Excitation& excitation, double horizon);
/// The motion of an answer, or its beginning.
[[nodiscard]] DrawnMotion drawn_motion(const SimulationRequest& request, const Simulation& answer);

}  // namespace stillpoint::report
