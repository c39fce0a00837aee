// SPDX-License-Identifier: MIT
#pragma once

#include "json_report.hpp"
#include "request.hpp"

#include <optional>
#include <string_view>
#include <vector>

namespace stillpoint::cli {

/// One figure in metres, seconds, kilograms, newtons or joules.
struct PhysicalValue {
  std::string_view field;       ///< in the JSON report; ends in its unit
  std::optional<double> value;  ///< empty: needs a mass, or the motion has none
};

/// The `physical` part of a report; no entries where the input was dimensionless.
[[nodiscard]] std::vector<PhysicalValue> design_quantities(const DesignInput& input,
                                                           const design::DesignResult& result);
[[nodiscard]] std::vector<PhysicalValue> region_quantities(const RegionInput& input,
                                                           const design::RegionAnswer& answer);
[[nodiscard]] std::vector<PhysicalValue> simulate_quantities(const SimulateInput& input,
                                                             const Simulation& answer);

}  // namespace stillpoint::cli
