// SPDX-License-Identifier: MIT
#pragma once

// The parts of a catalogue, and which of them a task takes.

#include <stillpoint/design/design_result.hpp>

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

/// How well a part fits a task.
struct RatedPart {
  Part part;
  bool admissible{false};           ///< with the tolerance asked for
  std::optional<double> tolerance;  ///< the largest; empty if the part itself is not admissible
  /// What the part itself violates; empty if it only lacks the tolerance asked for.
  std::vector<Constraint> violated;
};

struct Choice {
  /// The design with the best part, without a search. If no part is admissible there is no finding;
  /// `reason` says so, and `mends` are those of the parts.
  DesignResult result;
  std::vector<RatedPart> parts;  ///< all of them, best first
};

/// All parts, best first. Those that are admissible by the objective, then by their tolerance;
/// behind them those that lack tolerance, the most tolerant first; then the others, the one that
/// misses its worst constraint by the least factor first. Equals keep their order. Throws
/// InputError for a wrong problem and for f or delta not in [0, largest_part_value] or not a valid
/// oscillator.
[[nodiscard]] std::vector<RatedPart> ranked(const Problem& problem, const Limits& limits,
                                            Objective objective, std::span<const Part> parts);

/// The least change of the stroke, the tolerance, a limit or the arrivals, with the others
/// unchanged, that makes at least one of the parts admissible. None if one already is, and never of
/// v0 or p: parts are chosen for a given hit.
[[nodiscard]] std::vector<Mend> part_mends(const Problem& problem, const Limits& limits,
                                           std::span<const Part> parts);

/// Throws InputError for wrong input and for no parts. Under a pulse a part is judged by the run of
/// its own f.
[[nodiscard]] Choice choose(const DesignRequest& request, std::span<const Part> parts);

}  // namespace stillpoint::design
