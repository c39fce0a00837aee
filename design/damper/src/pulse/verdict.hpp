// SPDX-License-Identifier: MIT
#pragma once

// What an answer says of the region of a pulse, and of a damper in it.

#include "pulse/region.hpp"
#include "pulse/search.hpp"

#include <stillpoint/design/design_result.hpp>

#include <optional>
#include <vector>

namespace stillpoint::design {

/// The velocity to which a pulse reduces; empty where it leaves none.
[[nodiscard]] std::optional<double> reduced_v0(const Pulse& pulse, double f);

/// The region, and where it is empty why. `within` is an island with a box of the tolerance asked
/// for, empty if there is none.
[[nodiscard]] DesignResult without_finding(const PulseRequest& request, const PulseRegion& region,
                                           const std::optional<Island>& within);

/// The same around an optimum; where there is none with what would help.
[[nodiscard]] DesignResult around(const std::optional<PulseOptimum>& optimum,
                                  const PulseRequest& request, const PulseRegion& region);

/// The worst motion of the ranges, with f in the units of the region. An f >= k moves nothing.
[[nodiscard]] FirstReturn motion_at(const PulseRegion& region, double unit_f);

/// Of that motion. What never starts has no return and no acceleration of its own, and what does
/// not come back no stop.
[[nodiscard]] std::vector<Constraint> constraints_of(const PulseRequest& request,
                                                     const DesignPoint& point,
                                                     const FirstReturn& motion,
                                                     const PulseRegion& region);

/// The largest R of f and delta at once, whatever the shape of the box, of a point whose tolerance
/// is known for that shape.
[[nodiscard]] double even_tolerance(const PulseRequest& request, const PulseRegion& region,
                                    const DesignPoint& point, double unit_f);

/// `region` under a pulse.
[[nodiscard]] RegionAnswer answer_under_pulse(const RegionRequest& asked);

/// A damper, simulated and checked; `unit_f` is its f in the units of the region.
void add_finding(DesignResult& result, const PulseRequest& request, const PulseRegion& region,
                 const SearchResult& found, double unit_f);

}  // namespace stillpoint::design
