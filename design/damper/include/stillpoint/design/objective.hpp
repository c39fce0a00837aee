// SPDX-License-Identifier: MIT
#pragma once

#include <stillpoint/core/names.hpp>
#include <stillpoint/design/figures.hpp>

#include <optional>
#include <span>

namespace stillpoint::design {

/// What makes one admissible damper better than another. The last three optima lie on the edge of
/// the region, so ask for a tolerance with them.
enum class Objective {
  robust,        ///< largest R with every f (1 +- R), Delta (1 +- R) admissible
  amplitude,     ///< least peak displacement: the largest f
  time,          ///< least stop time: the smallest f
  acceleration,  ///< least acceleration of the free motion, transmitted and relative: smallest f
};

/// The objective's value for a motion; empty for `robust`, which a motion does not have, and for
/// the stop time of one that never stops.
[[nodiscard]] std::optional<double> objective_of(Objective objective, const Response& motion);

}  // namespace stillpoint::design
