// SPDX-License-Identifier: MIT
#pragma once

// The rows with which every report begins.

#include "json/schema.hpp"

#include <stillpoint/report/findings.hpp>
#include <stillpoint/report/page_frame.hpp>
#include <stillpoint/report/schemas.hpp>

namespace stillpoint::report {

inline constexpr auto program_names = std::to_array<std::string_view>({"stillpoint"});

[[nodiscard]] inline nlohmann::ordered_json version_schema() {
  return {{"type", "string"}, {"pattern", "^[0-9]+\\.[0-9]+\\.[0-9]+$"}};
}
struct Program {
  static constexpr std::tuple field_table{
      Field{"name", [](const Program&) { return program_names.front(); }, "",
            one_of(program_names)},
      Field{"version", [](const Program&) { return Printed<version_schema>{program_version()}; }}};
};

[[nodiscard]] inline nlohmann::ordered_json findings_schema() {
  using nlohmann::ordered_json;
  const ordered_json text{{"type", "string"}};
  return {
      {"type", "array"},
      {"items",
       {{"type", "object"},
        {"description", "with its values: docs/reports.md"},
        {"required", {"kind", "severity", "text"}},
        {"properties",
         {{"kind", text}, {"severity", {{"enum", {"info", "caution", "fault"}}}}, {"text", text}}},
        {"additionalProperties", {{"type", {"number", "string"}}}}}}};
}
using ShownFindings = Printed<findings_schema>;

/// `names` holds the name of the schema.
template <class Report, const auto& names>
inline constexpr auto head_fields =
    std::tuple{Field{"schema", [](const Report&) { return names.front(); }, "", {.texts = names}},
               Field{"program", [](const Report&) { return Program(); }}};

/// Of a report that has findings.
template <class Report>
inline constexpr auto told_fields =
    std::tuple{Field{"verdict", [](const Report& report) { return verdict(report); },
                     "the answer, in a sentence or two"},
               Field{"findings", [](const Report& report) {
                       return ShownFindings{findings_json(findings(report), report.physical)};
                     }}};

}  // namespace stillpoint::report
