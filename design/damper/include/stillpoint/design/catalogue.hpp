// SPDX-License-Identifier: MIT
#pragma once

#include <stillpoint/design/design.hpp>

#include <optional>
#include <span>
#include <string>
#include <vector>

namespace stillpoint::design {

/// A damper as it is sold.
struct Part {
  std::string name;
  double f{0};
  double delta{0};
};

/// A box around it stays within what f and Delta may be.
inline constexpr double largest_part_value = 1e299;

/// How a part stands against a task.
struct RatedPart {
  Part part;
  bool admissible{false};           ///< with the tolerance asked for
  std::optional<double> tolerance;  ///< the largest; empty if the part itself is not admissible
  /// What the part itself violates; empty if it only lacks the tolerance asked for.
  std::vector<Constraint> violated;
};

/// All parts, best first. Those that are admissible by the objective, then by their tolerance;
/// behind them those that lack tolerance, the most tolerant first; then the others, the one that
/// misses its worst constraint by the least factor first. Equals keep their order. Throws
/// InputError for a wrong problem and for f or delta not in [0, largest_part_value] or not a valid
/// oscillator.
[[nodiscard]] std::vector<RatedPart> ranked(const Problem& problem, const Limits& limits,
                                            Objective objective, std::span<const Part> parts);

/// The least change of the stroke, the tolerance, a limit or the arrivals, with the others
/// unchanged, that makes at least one of the parts admissible. None if one is, and none of v0 and
/// p: parts are chosen for a hit.
[[nodiscard]] std::vector<Mend> part_mends(const Problem& problem, const Limits& limits,
                                           std::span<const Part> parts);

struct Choice {
  /// Of the best part, without a search; without a finding if no part is admissible, which `reason`
  /// says, with `mends` of the parts.
  DesignResult result;
  std::vector<RatedPart> parts;  ///< all of them, best first
};

/// Throws InputError for wrong input and for no parts. Under a pulse a part is judged by the run of
/// its own f.
[[nodiscard]] Choice choose(const DesignRequest& request, std::span<const Part> parts);

}  // namespace stillpoint::design
