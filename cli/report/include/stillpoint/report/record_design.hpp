// SPDX-License-Identifier: MIT
#pragma once

// The report of a design under records.

#include <stillpoint/design/physical.hpp>
#include <stillpoint/design/record_design.hpp>
#include <stillpoint/figures/html_page.hpp>
#include <stillpoint/report/document.hpp>

#include <nlohmann/json.hpp>

#include <array>
#include <cstddef>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace stillpoint::report {

struct RecordDesignInput {
  design::RecordDesignRequest request;
  std::optional<design::PhysicalInput> physical{};
};

struct RecordDesignReport {
  design::RecordDesign result;
  std::optional<design::PhysicalInput> physical{};
};

/// Of a design with a damper: the record with the largest figure of the objective, or of several
/// the one with the largest stroke.
[[nodiscard]] std::size_t worst_record(const design::RecordDesign& result);

/// How far a search is, in about 80 characters.
[[nodiscard]] std::string progress_words(const design::RecordProgress& progress,
                                         const std::optional<design::PhysicalInput>& physical);

[[nodiscard]] inline const std::vector<design::Finding>& findings(
    const RecordDesignReport& report) {
  return report.result.findings;
}
/// What to build and what it does, or what is in the way.
[[nodiscard]] std::string verdict(const RecordDesignReport& report);
[[nodiscard]] Document document(const RecordDesignReport& report);
/// As docs/reports.md describes it.
[[nodiscard]] nlohmann::ordered_json json(const RecordDesignReport& report);
/// The maps of the objective, the motion under each record with its load, and the spectra about the
/// chosen period; they are computed here.
[[nodiscard]] figures::HtmlPage page(const RecordDesignReport& report);

inline constexpr std::size_t most_drawn_records = 11;
/// The ids of the figures that the page may have, besides those of a spectrum.
inline constexpr std::array<std::string_view, 26> record_design_figures{
    "map",           "map-near",      "worst",         "worst-load",    "record-1",
    "record-2",      "record-3",      "record-4",      "record-5",      "record-6",
    "record-7",      "record-8",      "record-9",      "record-10",     "record-11",
    "record-1-load", "record-2-load", "record-3-load", "record-4-load", "record-5-load",
    "record-6-load", "record-7-load", "record-8-load", "record-9-load", "record-10-load",
    "record-11-load"};

}  // namespace stillpoint::report
