// SPDX-License-Identifier: MIT
#pragma once

// The admissible region, part by part, and the answer to a request.

#include <stillpoint/design/admissible_region.hpp>
#include <stillpoint/design/constraints.hpp>
#include <stillpoint/design/mends.hpp>
#include <stillpoint/design/region_result.hpp>
#include <stillpoint/design/strips.hpp>
#include <stillpoint/design/tolerance.hpp>

#include <string>

namespace stillpoint::design {

/// The answer in one line for people: the interval of f, or why the region is empty.
[[nodiscard]] std::string summary(const RegionVerdict& verdict);

/// Throws InputError as admissible_region does, for f or delta not in [0, 1e300], and for delta
/// without f; with a pulse as the design does (design.hpp).
[[nodiscard]] RegionAnswer answer(const RegionRequest& request);

}  // namespace stillpoint::design
