// SPDX-License-Identifier: MIT
#pragma once

#include <stillpoint/design/problem.hpp>

#include <cstdint>
#include <optional>
#include <vector>

namespace stillpoint::design {

/// The dampers that stop at one arrival, within the limits: docs/theory.md section 12.
struct Strip {
  std::int64_t arrival{1};
  double beta_min{0};             ///< below it there is none, (49)
  std::optional<double> f_lower;  ///< as in Region; empty if no box of the tolerance asked for fits
  std::optional<double> f_upper;
  double tolerance{0};  ///< the largest of any of them, regardless of the one asked for
  bool at_peak{false};  ///< arrival 0, where only the first peak is within the residual
};

/// The strips of the arrivals that are allowed, without those that are empty for any tolerance.
/// Throws InputError.
[[nodiscard]] std::vector<Strip> strips(const Problem& problem, const Limits& limits = {});

/// In rising order, those that overlap as one.
[[nodiscard]] std::vector<Interval> merged(std::vector<Interval> all);
/// The f of any of them with the tolerance asked for.
[[nodiscard]] std::vector<Interval> feasible_f(const std::vector<Strip>& strips);

/// The Delta with which a damper with that f stops the mass at the n-th arrival: the lower edge is
/// excluded, the peak and the limits are not checked. Accurate to a few roundings; empty if there
/// is none. Throws InputError.
[[nodiscard]] std::optional<Interval> delta_range(const Problem& problem, std::int64_t arrival,
                                                  double f);

/// The Delta with which a damper of that f stops the mass at the n-th arrival, or for n = 0 rests
/// within the residual whatever the arrival, and keeps all limits over the box of their tolerance;
/// empty if there is none. The lower edge as above. Throws InputError.
[[nodiscard]] std::optional<Interval> feasible_delta(const Problem& problem, const Limits& limits,
                                                     std::int64_t arrival, double f);

/// The f beyond which no Delta lets the mass stop or rest as it must. Throws InputError.
[[nodiscard]] double largest_stopping_f(const Problem& problem);
/// That is f1 or more: only the dead zone bounds f. Throws InputError.
[[nodiscard]] bool dead_zone_binds(const Problem& problem);

/// The Delta below which the mass passes x = 0 more often than it may; 0 where it never does.
/// Throws InputError.
[[nodiscard]] double least_stopping_delta(const Problem& problem, double f);

/// The arrival, of those that are allowed, at which the damper stops the mass at x = 0 by the
/// problem's criterion; empty if there is none. The peak and the limits are not checked.
/// Throws as admissible() does.
[[nodiscard]] std::optional<std::int64_t> arrival_of(const Problem& problem, double f,
                                                     double delta);

}  // namespace stillpoint::design
