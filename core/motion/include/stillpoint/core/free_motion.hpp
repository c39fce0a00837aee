// SPDX-License-Identifier: MIT
#pragma once

#include <stillpoint/core/oscillator.hpp>
#include <stillpoint/core/state.hpp>

#include <optional>
#include <string>

namespace stillpoint {

/// What to compute beyond the counts, the peaks and the place of rest.
struct FreeOptions {
  bool times{true};   ///< stop_time: two more square roots per half-cycle
  bool margin{true};  ///< decision_margin: one division per half-cycle
  /// With both frictions the number of half-cycles is bounded before the run; a bound above this is
  /// refused with TooManyHalfCycles. Motions with one friction or none are closed forms and
  /// need no limit. In [1, 1e15]; each 1e8 takes a few seconds.
  double half_cycle_limit{1e8};
};

/// The metrics of one motion, dimensionless. What does not exist is empty: all but the peaks and
/// the jump where the motion never stops; arrival_speed where it never arrives at x = 0;
/// decision_margin where nothing was decided.
struct Response {
  Outcome outcome{Outcome::never_stops};
  bool stops_at_zero{false};
  double peak_amplitude{0};               ///< largest |x|, the start included
  double peak_acceleration{0};            ///< largest |x''| away from the notch, relative
  double peak_absolute_acceleration{0};   ///< as the structure feels it: docs/forced.md section 10
  double jump{0};                         ///< the largest, of |x'|, at a notch without width
  std::optional<double> half_cycles;      ///< 1 + zero_passages; 0 where nothing moves
  std::optional<double> turning_points;   ///< x' = 0 at x != 0, reached from motion, rest included
  std::optional<double> zero_passages;    ///< arrivals at x = 0 after which the motion goes on
  std::optional<double> stop_time;        ///< tau; empty also where FreeOptions::times is false
  std::optional<double> stop_position;    ///< signed
  std::optional<double> arrival_speed;    ///< at the last arrival at x = 0, before the notch acts
  std::optional<double> decision_margin;  ///< docs/theory.md section 6; empty also if not asked for

  [[nodiscard]] bool operator==(const Response&) const = default;
};
// Counts are doubles that hold integers: exact below 2^53, and the closed forms go far beyond that.

/// The free motion (W = 0) of `oscillator` from `start`, exact except for rounding: each metric is
/// exact for inputs changed by a relative 2e-16 * (2 + half-cycles) at most, and a count or
/// outcome may differ only where decision_margin is below that. Throws InputError (oscillator.hpp
/// says when) and TooManyHalfCycles. docs/theory.md sections 2-6.
[[nodiscard]] Response free_response(const Oscillator& oscillator, const Start& start,
                                     const FreeOptions& options = {});

/// The response in one line for people: "stops at x = 0 at tau = 34.6 after 11 half-cycles, peak
/// 0.98".
[[nodiscard]] std::string summary(const Response& response);

/// Only peak_amplitude, in constant time for any number of half-cycles. Throws InputError.
[[nodiscard]] double free_peak(const Oscillator& oscillator, const Start& start);

}  // namespace stillpoint
