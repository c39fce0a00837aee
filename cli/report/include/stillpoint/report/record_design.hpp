// SPDX-License-Identifier: MIT
#pragma once

// The report of a design under records.

#include <stillpoint/design/physical.hpp>
#include <stillpoint/design/record_design.hpp>
#include <stillpoint/figures/figure.hpp>
#include <stillpoint/report/document.hpp>

#include <nlohmann/json.hpp>

#include <optional>

namespace stillpoint::report {

struct RecordDesignInput {
  design::RecordDesignRequest request;
  std::optional<design::PhysicalInput> physical{};
  std::string parts_file{};  ///< of a catalogue
  bool of_region{false};     ///< which judges a damper, and finds none
};

struct RecordDesignReport {
  RecordDesignReport(design::RecordDesign found, const RecordDesignInput& input)
      : result(std::move(found)),
        physical(input.physical),
        parts_file(input.parts_file),
        of_region(input.of_region) {}

  design::RecordDesign result;
  std::optional<design::PhysicalInput> physical;
  std::string parts_file;
  bool of_region;
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
