// SPDX-License-Identifier: MIT
#pragma once

// What an answer says of the region of a pulse, and of a damper in it.

#include "pulse_region.hpp"

#include <stillpoint/design/design.hpp>

#include <optional>
#include <vector>

namespace stillpoint::design {

/// The request as the forced motion has it: v0 is the velocity to which the motion shown reduces,
/// if there is one.
[[nodiscard]] DesignRequest reduced(const PulseRequest& request, const Pulse& shown, double f);

/// The region, and where it is empty why. `within` is an island with a box of the tolerance asked
/// for, empty if there is none.
[[nodiscard]] DesignResult without_finding(const PulseRequest& request, const PulseRegion& region,
                                           const std::optional<Island>& within);

/// `motion` is the worst of the ranges.
[[nodiscard]] std::vector<Constraint> constraints_of(const PulseRequest& request,
                                                     const DesignPoint& point,
                                                     const FirstReturn& motion,
                                                     const PulseRegion& region);

/// A damper, simulated and checked; `unit_f` is its f in the units of the region.
void add_finding(DesignResult& result, const PulseRequest& request, const PulseRegion& region,
                 const SearchResult& found, double unit_f);

}  // namespace stillpoint::design
