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

/// Whether the damper is built as it is designed; a width alone does not count.
[[nodiscard]] bool is_exact(const design::SuiteTolerance& of);

/// In the words of a damper; of none without Delta.
[[nodiscard]] design::NotchShape notch_of(const design::RecordDesignRequest& task,
                                          const design::SuiteDamper& damper);

/// The motion of a damper under one of the records.
[[nodiscard]] SimulationRequest motion_request(const design::RecordDesign& result,
                                               const design::SuiteDamper& damper,
                                               std::size_t record);

/// What holds the mass, and which records end with it held or moving.
void add_rest(Section& answer, const design::RecordDesign& result);
/// The figures under the worst record of a mean.
void add_worst_of_mean(Section& answer, const design::RecordDesign& result,
                       const Physical& physical);
void add_records(Document& document, const design::RecordDesign& result, const Physical& physical);
/// Of the motion that came closest to another outcome.
void add_decision_margin(Section& section, const design::RecordDesign& result);
/// What was tried about the damper, and what it does itself.
void add_box(Section& answer, const design::RecordDesign& result, const Physical& physical);
/// What a period, or a scale of the records, that is off would do.
void add_outlook(Document& document, const design::RecordDesign& result, const Physical& physical);
/// Of a design: as many as it was rounded to, or almost every digit that it has.
inline constexpr int printed_digits = 12;
/// In which a period is printed; the usual ones unless it was searched.
[[nodiscard]] std::optional<int> period_digits(const design::RecordDesignRequest& task);

/// "0.1991 g transmitted, stroke 307.18 mm, residual 35.709 mm"
[[nodiscard]] std::string figures_words(const design::SuiteFigures& figures,
                                        const Physical& physical);

}  // namespace stillpoint::report
