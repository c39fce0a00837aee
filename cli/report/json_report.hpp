// SPDX-License-Identifier: MIT
#pragma once

#include "request.hpp"

#include <nlohmann/json.hpp>

#include <optional>
#include <string>
#include <vector>

namespace stillpoint::cli {

/// Parts of more than one report.
[[nodiscard]] nlohmann::ordered_json program_json();
[[nodiscard]] nlohmann::ordered_json simulate_input_json(const SimulateInput& input);

/// The reports that docs/reports.md describes. Numbers carry a double's full precision; a value
/// that does not exist is null; a number that is not finite is an assertion.
[[nodiscard]] nlohmann::ordered_json design_json(const DesignInput& input,
                                                 const design::DesignResult& result);
[[nodiscard]] nlohmann::ordered_json region_json(const RegionInput& input,
                                                 const design::RegionAnswer& answer);
[[nodiscard]] nlohmann::ordered_json simulate_json(const SimulateInput& input,
                                                   const Simulation& answer);

}  // namespace stillpoint::cli
