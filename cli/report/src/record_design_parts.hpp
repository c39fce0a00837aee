// SPDX-License-Identifier: MIT
#pragma once

// The parts of the document of a design under records.

#include "sections.hpp"

#include <stillpoint/core/simulation.hpp>
#include <stillpoint/design/record_design.hpp>

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>

namespace stillpoint::report {

struct RecordDesignReport;

/// "the record", "every record", "1 of 2 records"
[[nodiscard]] std::string of_records(std::size_t count, std::size_t all);

[[nodiscard]] std::string figure_shown(const Physical& physical,
                                       const design::SuiteFigureKind& kind, double value);
/// Whether the damper is built as it is designed; a width alone does not count.
[[nodiscard]] bool is_exact(const design::SuiteTolerance& of);

/// A stroke or a residual; "less than 0.001 mm" of what nobody can measure.
[[nodiscard]] std::string displacement_shown(const Physical& physical, double length,
                                             std::optional<int> digits = {});

/// What to build and what it does, or what is in the way.
[[nodiscard]] std::string record_verdict(const RecordDesignReport& report);

/// In the words of a damper; of none without Delta.
[[nodiscard]] design::NotchShape notch_of(const design::RecordDesignRequest& task,
                                          const design::SuiteDamper& damper);

/// The motion of a damper under one of the records.
[[nodiscard]] SimulationRequest motion_request(const design::RecordDesign& result,
                                               const design::SuiteDamper& damper,
                                               std::size_t record);

/// What holds the mass, and which records end with it held or moving.
void add_rest(Section& answer, const design::RecordDesign& result);
/// The figures under the worst record of a mean, which may be far beyond the limits.
/// And each record that exceeds a limit which the mean keeps.
void add_worst_of_mean(Section& answer, const design::RecordDesign& result,
                       const Physical& physical);
void add_records(Document& document, const design::RecordDesign& result, const Physical& physical);
/// "locked in the notch to the end of every record; ..."; empty if no record locks the mass.
[[nodiscard]] std::string lock_words(const design::RecordDesign& result);

/// Whether its figures are means of several records.
[[nodiscard]] bool is_mean(const design::RecordDesignRequest& task);

/// Of the motion that came closest to another outcome.
void add_decision_margin(Section& section, const design::RecordDesign& result);
/// What was tried about the damper, and what it does itself.
void add_box(Section& answer, const design::RecordDesign& result, const Physical& physical);
/// What a period, or a scale of the records, that is off would do.
void add_outlook(Section& answer, const design::RecordDesign& result, const Physical& physical);
/// "no failure in 4000 dampers"; empty if only the damper itself was tried.
[[nodiscard]] std::string samples_words(const design::SuiteBox& box);

/// Of a design: as many as it was rounded to, or almost every digit that it has.
inline constexpr int printed_digits = 12;
/// In which a period is printed; the usual ones unless it was searched.
[[nodiscard]] std::optional<int> period_digits(const design::RecordDesignRequest& task);

/// "0.1991 g transmitted, stroke 307.18 mm, residual 35.709 mm"
[[nodiscard]] std::string figures_words(const design::SuiteFigures& figures,
                                        const Physical& physical);

}  // namespace stillpoint::report
