// SPDX-License-Identifier: MIT
#pragma once

// The JSON Schemas of the reports, from the tables of their fields.

#include <nlohmann/json.hpp>

#include <array>
#include <string_view>

namespace stillpoint::report {

[[nodiscard]] nlohmann::ordered_json accuracy_schema();
[[nodiscard]] nlohmann::ordered_json design_schema();
[[nodiscard]] nlohmann::ordered_json region_schema();
[[nodiscard]] nlohmann::ordered_json simulation_schema();
[[nodiscard]] nlohmann::ordered_json spectrum_schema();
[[nodiscard]] nlohmann::ordered_json reduction_report_schema();
[[nodiscard]] nlohmann::ordered_json sweep_schema();

struct ReportSchema {
  std::string_view name;  ///< data/schemas/NAME.schema.json
  nlohmann::ordered_json (*make)();
};
inline constexpr std::array report_schemas{
    ReportSchema{"accuracy-report-1", accuracy_schema},
    ReportSchema{"design-report-2", design_schema},
    ReportSchema{"region-report-2", region_schema},
    ReportSchema{"simulation-report-1", simulation_schema},
    ReportSchema{"spectrum-report-1", spectrum_schema},
    ReportSchema{"sweep-reduction-1", reduction_report_schema},
    ReportSchema{"sweep-report-1", sweep_schema}};

}  // namespace stillpoint::report
