// SPDX-License-Identifier: MIT
#pragma once

#include <stillpoint/core/names.hpp>
#include <stillpoint/core/oscillator.hpp>
#include <stillpoint/design/problem.hpp>
#include <stillpoint/design/pulse.hpp>

#include <optional>
#include <span>
#include <vector>

namespace stillpoint::design {

/// How the motion after a hit ends.
enum class HitEnd {
  held,             ///< V0^2 < 2 Delta, or k <= f: it never starts
  centred,          ///< it stops at x = 0
  within_residual,  ///< it rests off centre, but not farther than the residual that is allowed
  off_centre,       ///< it rests in the dead zone
  alternating,      ///< alternately centred and off centre, not listed one by one
  passes,           ///< of a pulse: it passes x = 0 at its first return
  too_far,          ///< its peak exceeds beta, wherever it ends
  never_stops,      ///< there is no friction
};

using stillpoint::name;

/// The V0 between two edges, all of which end alike. The edges themselves belong to `centred`;
/// otherwise to the segment below for too_far and to the one above for held.
struct Hits {
  double from{0};
  double to{0};
  HitEnd end{HitEnd::held};
  /// Arrivals at x = 0, the stop included; for `alternating`, the least. Empty for held, too_far
  /// and never_stops.
  std::optional<double> arrivals;
  /// For a rest off centre, the position that is farthest from x = 0, with its sign for V0 > 0.
  std::optional<double> rest;
  bool every_spring{true};  ///< of a range of springs; else some end like this, the others better
};

/// Every V0 from 0 to `v0_most`, in order and without gaps, for a start at x = 0. With little
/// friction there are many segments: once this many are listed, the others up to the limit of the
/// peak become one, `alternating`. A single V0 that ends differently from both of its neighbours
/// (with only one friction) is not a segment.
inline constexpr int most_hit_segments = 100;

/// Edges in closed form, docs/theory.md (39) to (42). Throws InputError for a wrong oscillator,
/// beta not in [1e-300, 1e300], v0_most not in [1e-150, 1e150] and a residual below 0.
[[nodiscard]] std::vector<Hits> hits(const Oscillator& oscillator, double beta, double v0_most,
                                     double residual = 0);

/// Those that reports show: up to twice the problem's v0, for the worst of its springs; where it
/// has a range of them, without `rest`.
[[nodiscard]] std::vector<Hits> shown_hits(const Problem& problem, double f, double delta);

/// Of those, the ones whose peak is within beta, but whose acceleration outside the notch is not
/// within its limit: sqrt(f^2 + (v0 p)^2) is above it, with the stiffest spring.
[[nodiscard]] std::optional<Interval> hits_above_limit(const Problem& problem, const Limits& limits,
                                                       double f, const std::vector<Hits>& hits);

/// Every k of a pulse, from 0 to twice the strongest or to `k_most` if that is larger, of the worst
/// of the lengths and springs of the ranges, by the motion up to its first return: docs/theory.md
/// (71).
[[nodiscard]] std::vector<Hits> shown_strengths(const PulseProblem& problem, double f, double delta,
                                                double k_most = 0);

}  // namespace stillpoint::design
