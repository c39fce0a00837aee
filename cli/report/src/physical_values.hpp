// SPDX-License-Identifier: MIT
#pragma once

#include <stillpoint/report/report.hpp>

#include <nlohmann/json.hpp>

namespace stillpoint::report {

/// The field `physical` of a report: metres, seconds, kilograms, newtons and joules. Null where the
/// input was dimensionless; a value is null that needs a mass, or that the motion does not have.
[[nodiscard]] nlohmann::ordered_json physical_json(const DesignReport& report);
[[nodiscard]] nlohmann::ordered_json physical_json(const RegionReport& report);
[[nodiscard]] nlohmann::ordered_json physical_json(const MotionReport& report);

}  // namespace stillpoint::report
