// SPDX-License-Identifier: MIT
#pragma once

#include "json_report.hpp"
#include "page.hpp"
#include "request.hpp"

#include <optional>
#include <string>

namespace stillpoint::cli {

/// The reports for people; `title` is the scene's own heading.
[[nodiscard]] std::string design_text(const DesignInput& input, const design::DesignResult& result,
                                      const std::optional<std::string>& title, Style style);
[[nodiscard]] std::string region_text(const RegionInput& input, const design::RegionAnswer& answer,
                                      const std::optional<std::string>& title, Style style);
[[nodiscard]] std::string simulate_text(const SimulateInput& input, const Simulation& answer,
                                        const std::optional<std::string>& title, Style style);

}  // namespace stillpoint::cli
