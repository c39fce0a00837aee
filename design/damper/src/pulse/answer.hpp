// SPDX-License-Identifier: MIT
#pragma once

// The answers of `region` and `choose` under a pulse, and what they share with that of `design`.

#include "pulse/region.hpp"

#include <stillpoint/design/choice.hpp>

#include <optional>
#include <span>

namespace stillpoint::design {

/// `region` under a pulse.
[[nodiscard]] RegionAnswer answer_under_pulse(const RegionRequest& asked);

/// `choose` under a pulse.
[[nodiscard]] Choice choose_under_pulse(const PulseRequest& request, std::span<const Part> parts);

/// Throws InputError for a wrong request.
[[nodiscard]] PulseRegion region_for(const PulseRequest& request);

/// The region around an optimum; without one, why it is empty and what would help.
[[nodiscard]] DesignResult around(const std::optional<PulseOptimum>& optimum,
                                  const PulseRequest& request, const PulseRegion& region);

/// The largest R of f and delta at once, for any shape of the box, at a point whose tolerance is
/// known for that shape.
[[nodiscard]] double even_tolerance(const PulseRequest& request, const PulseRegion& region,
                                    const DesignPoint& point, double unit_f);

/// A damper, simulated and checked; `unit_f` is its f in the units of the region.
void add_finding(DesignResult& result, const PulseRequest& request, const PulseRegion& region,
                 const DesignPoint& point, double unit_f);

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
