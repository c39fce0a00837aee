// SPDX-License-Identifier: MIT
#pragma once

// Findings in words: one sentence a kind, from its own values alone.

#include <stillpoint/design/finding.hpp>
#include <stillpoint/design/physical.hpp>
#include <stillpoint/report/document.hpp>

#include <nlohmann/json.hpp>

#include <optional>
#include <span>

namespace stillpoint::report {

/// A pattern of data/words, filled with values {name} or {name:form}. Of [one|other] stands the
/// first of which all values exist, if any. {name?} has no words and exists if the value does,
/// {name=other?} if it is that text or has the value of that name.
[[nodiscard]] std::string filled(std::string_view pattern,
                                 std::span<const design::FindingValue> values,
                                 const std::optional<design::PhysicalInput>& physical);
[[nodiscard]] std::string words(const design::Finding& finding,
                                const std::optional<design::PhysicalInput>& physical);

/// Each with its kind, severity, text and values, those with a dimension in SI units as well.
[[nodiscard]] nlohmann::ordered_json findings_json(
    std::span<const design::Finding> findings,
    const std::optional<design::PhysicalInput>& physical);

/// What a verdict begins with: "Build", unless a fault or too little tolerance forbids that.
[[nodiscard]] std::string_view advice(std::span<const design::Finding> findings,
                                      std::string_view usual = "Build");

/// A line for each of them, around what the answer has already: faults and cautions before it,
/// notes behind it; and the tone of the verdict.
void add_findings(Document& document, std::span<const design::Finding> findings,
                  const std::optional<design::PhysicalInput>& physical);

}  // namespace stillpoint::report
