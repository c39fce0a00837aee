// SPDX-License-Identifier: MIT
#pragma once

// The answers of `region` and `choose` under a pulse, and what they share with that of `design`.

#include "pulse/region.hpp"
#include "pulse/search.hpp"

#include <stillpoint/design/choice.hpp>

#include <optional>
#include <span>

namespace stillpoint::design {

/// `region` under a pulse.
[[nodiscard]] RegionAnswer answer_under_pulse(const RegionRequest& asked);

/// `choose` under a pulse.
[[nodiscard]] Choice choose_under_pulse(const PulseRequest& request, std::span<const Part> parts);

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
