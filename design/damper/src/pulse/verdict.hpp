// SPDX-License-Identifier: MIT
#pragma once

// What an answer says about the region of a pulse, and about a damper in it.

#include "pulse/region.hpp"
#include "pulse/search.hpp"

#include <stillpoint/design/design_result.hpp>

#include <optional>
#include <vector>

namespace stillpoint::design {

/// The velocity to which a pulse reduces; empty if it leaves none.
[[nodiscard]] std::optional<double> reduced_v0(const Pulse& pulse, double f);

/// The region, and if it is empty, why. `within` is a damper with the tolerance asked for, around
/// which the interval of f is; empty if there is none.
[[nodiscard]] DesignResult without_finding(const PulseRequest& request, const PulseRegion& region,
                                           const std::optional<PulseOptimum>& within);

/// The worst motion of the ranges, with f in the units of the region. With f >= k nothing moves.
[[nodiscard]] FirstReturn motion_at(const PulseRegion& region, double unit_f);

/// The constraints of that motion. A mass that never starts has no return and no acceleration, and
/// one that does not come back has no stop.
[[nodiscard]] std::vector<Constraint> constraints_of(const PulseRequest& request,
                                                     const DesignPoint& point,
                                                     const FirstReturn& motion,
                                                     const PulseRegion& region);

}  // namespace stillpoint::design
