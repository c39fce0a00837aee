// SPDX-License-Identifier: MIT
#pragma once

// The answer of `region` under a pulse, and the parts that those of `design` and `choose` share
// with it.

#include "pulse/region.hpp"
#include "pulse/search.hpp"

#include <stillpoint/design/pulse_request.hpp>

#include <optional>

namespace stillpoint::design {

/// `region` under a pulse.
[[nodiscard]] RegionAnswer answer_under_pulse(const RegionRequest& asked);

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

}  // namespace stillpoint::design
