// SPDX-License-Identifier: MIT
#pragma once

// Which parts of a catalogue a task takes.

#include <stillpoint/design/choice.hpp>

#include <span>
#include <vector>

namespace stillpoint::design {

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
