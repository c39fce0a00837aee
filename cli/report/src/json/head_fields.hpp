// SPDX-License-Identifier: MIT
#pragma once

// The rows with which every report begins.

#include "json/motion_fields.hpp"

#include <stillpoint/report/findings.hpp>

#include <span>
#include <tuple>

namespace stillpoint::report {

struct ShownFindings {
  std::span<const design::Finding> all;
  Physical physical;
};

[[nodiscard]] inline nlohmann::ordered_json own_json(const ShownFindings& findings) {
  return findings_json(findings.all, findings.physical);
}

[[nodiscard]] inline nlohmann::ordered_json own_schema(const ShownFindings* /*of*/) {
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
                       return ShownFindings{findings(report), report.physical};
                     }}};

}  // namespace stillpoint::report
