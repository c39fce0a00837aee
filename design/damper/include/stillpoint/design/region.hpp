// SPDX-License-Identifier: MIT
#pragma once

// The admissible region, part by part, and the answer to a request.

#include <stillpoint/design/admissible_region.hpp>
#include <stillpoint/design/constraints.hpp>
#include <stillpoint/design/region_result.hpp>
#include <stillpoint/design/strips.hpp>
#include <stillpoint/design/tolerance.hpp>

#include <optional>
#include <string>
#include <vector>

namespace stillpoint::design {

/// One entry for each input that suffices alone; none if the region is not empty. Throws InputError
/// as admissible_region does; so does the next one.
[[nodiscard]] std::vector<Mend> mends(const Problem& problem, const Limits& limits);

/// The largest tolerance of any damper, whatever beta and the limits are; empty unless that is less
/// than what is asked for.
[[nodiscard]] std::optional<double> largest_tolerance_of_any(Problem problem, const Limits& limits);

/// The exact criterion, if it is not the problem's and leaves a region that is not empty.
[[nodiscard]] std::optional<Criterion> criterion_mend(const Problem& problem, const Limits& limits);

/// Completes the verdict of an empty region.
void explain(RegionVerdict& empty, const Problem& problem, const Limits& limits);

/// The answer in one line for people: the interval of f, or why the region is empty.
[[nodiscard]] std::string summary(const RegionVerdict& verdict);

/// Throws InputError as admissible_region does, for f or delta that no oscillator has, and for
/// delta without f; with a pulse as the design does (design.hpp).
[[nodiscard]] RegionAnswer answer(const RegionRequest& request);

}  // namespace stillpoint::design
