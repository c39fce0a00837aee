// SPDX-License-Identifier: MIT
#pragma once

// The findings of a report in its table of fields.

#include "units.hpp"

#include <stillpoint/report/findings.hpp>

#include <nlohmann/json.hpp>

#include <span>

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

}  // namespace stillpoint::report
