// SPDX-License-Identifier: MIT
#pragma once

#include <stillpoint/design/limit_kinds.hpp>
#include <stillpoint/design/problem.hpp>

#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace stillpoint::design {

/// Why no (f, Delta) is admissible, by the two constraints that conflict.
enum class Conflict {
  none,
  amplitude_against_return,     ///< f2 > f3, or their boxes do not fit: condition (10) fails
  amplitude_against_dead_zone,  ///< f2 > f1, with a residual
  amplitude_against_limit,      ///< f2 > the f of a limit
  limit_alone,                  ///< which is exceeded without any friction
  stop_against_start,           ///< Delta1 > Delta2 over the tolerance box
  stop_against_limit,           ///< Delta1 > the Delta of a limit
  no_arrival,                   ///< of several arrivals none has a box that fits
  narrower_than_rounding,       ///< the rest of the region lies between neighbouring doubles
};

/// The admissible region max(f2, 0) <= f <= f3, Delta1(f) < Delta <= Delta2, and its part within
/// the limits. f1, f2, f3 and delta2 are the paper's; f2 is negative if amplitude does not bind.
struct Region {
  bool feasible{false};
  Conflict conflict{Conflict::none};
  const LimitKind* limit{nullptr};  ///< of the conflict, if it is with one
  double f1{0};
  double f2{0};
  double f3{0};
  /// f <= f4 keeps S = sqrt(f^2 + p^2 V0^2) within acceleration_max; negative if p V0 alone exceeds
  /// that. Empty without the limit.
  std::optional<double> f4;
  std::optional<double> delta2;  ///< empty under a pulse, which starts the mass whatever Delta is
  double beta_min{0};  ///< V0/(sqrt(2) p), condition (10); the least double that is feasible
  /// The interval of feasible f within every limit, for the middle of the tolerance box. Empty if
  /// not feasible. The lower end itself is excluded where it comes from Delta (Delta1 < Delta is
  /// strict) or is 0.
  std::optional<double> f_lower;
  std::optional<double> f_upper;
};

/// Edges are computed in pairs of doubles and rounded inwards, so that what is admissible in
/// doubles is admissible. With several arrivals f_lower and f_upper are the least and the largest f
/// of all strips, the other edges those of the first arrival. Throws InputError (problem.hpp).
[[nodiscard]] Region admissible_region(const Problem& problem, const Limits& limits = {});

/// The factors of the deltas and velocities in a sentence, and their units.
struct ReasonUnits {
  double delta{1};
  std::string delta_unit{};
  double velocity{1};
  std::string velocity_unit{};
};

/// The constraints and limits that conflict, by name; empty where none do.
[[nodiscard]] std::optional<std::vector<std::string_view>> conflicting(const Region& region);

/// Why the region is empty, as a sentence with the numbers; empty if it is not.
[[nodiscard]] std::optional<std::string> reason(const Region& region, const Problem& problem,
                                                const Limits& limits = {},
                                                const ReasonUnits& units = {});

/// Delta1(f) of the paper, (26). Throws InputError unless f in [0, 1e300].
[[nodiscard]] double delta1_published(const Problem& problem, double f);
/// Delta1(f) of the model, (27); empty for f > f3, where the motion does not return.
[[nodiscard]] std::optional<double> delta1_exact(const Problem& problem, double f);
/// By the problem's criterion.
[[nodiscard]] std::optional<double> delta1(const Problem& problem, double f);

}  // namespace stillpoint::design
