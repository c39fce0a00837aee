// SPDX-License-Identifier: MIT
#pragma once

// The report of a design under records.

#include <stillpoint/design/physical.hpp>
#include <stillpoint/design/record_design.hpp>
#include <stillpoint/figures/figure.hpp>
#include <stillpoint/report/document.hpp>

#include <nlohmann/json.hpp>

#include <optional>
#include <string>
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

/// How far a search is, in about 80 characters.
[[nodiscard]] std::string progress_words(const design::RecordProgress& progress,
                                         const std::optional<design::PhysicalInput>& physical);

/// What to build and what it does, or what is in the way.
[[nodiscard]] std::string verdict(const RecordDesignReport& report);
[[nodiscard]] Document document(const RecordDesignReport& report);
/// As docs/reports.md describes it.
[[nodiscard]] nlohmann::ordered_json json(const RecordDesignReport& report);
/// The maps of the objective, the motion under each record with its load, and the spectra about the
/// chosen period; they are computed here.
[[nodiscard]] std::vector<figures::Figure> drawings(const RecordDesignReport& report);

inline constexpr int most_drawn_records = 11;

}  // namespace stillpoint::report
