// SPDX-License-Identifier: MIT
#pragma once

// The JSON Schemas of the reports, from the tables of their fields.

#include <nlohmann/json.hpp>

#include <array>
#include <string_view>

namespace stillpoint::report {

[[nodiscard]] nlohmann::ordered_json accuracy_schema();
[[nodiscard]] nlohmann::ordered_json simulation_schema();

struct ReportSchema {
  std::string_view name;  ///< data/schemas/NAME.schema.json
  nlohmann::ordered_json (*make)();
};
inline constexpr std::array report_schemas{ReportSchema{"accuracy-report-1", accuracy_schema},
                                           ReportSchema{"simulation-report-1", simulation_schema}};

}  // namespace stillpoint::report
