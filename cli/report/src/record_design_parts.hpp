// SPDX-License-Identifier: MIT
#pragma once

// The parts of the document of a design under records.

#include "sections.hpp"

#include <stillpoint/core/simulation.hpp>
#include <stillpoint/design/record_design.hpp>

#include <cstddef>
#include <string>
#include <string_view>

namespace stillpoint::report {

/// "the record", "every record", "1 of 2 records"
[[nodiscard]] std::string of_records(std::size_t count, std::size_t all);

[[nodiscard]] std::string figure_shown(const Physical& physical, design::SuiteObjective which,
                                       double value);

/// If the design has the paper's notch: what one of the example width spoils, in a sentence; empty
/// if nothing.
[[nodiscard]] std::string example_sentence(const design::RecordDesign& result,
                                           const Physical& physical);
/// The impulses of a notch without a width; and if it is the paper's, what the mass feels in one
/// with a width, and how wide that must be.
void add_notch(Section& answer, const design::RecordDesign& result, const Physical& physical);

/// The motion of the design under one of its records.
[[nodiscard]] SimulationRequest motion_request(const design::RecordDesign& result,
                                               std::size_t record);

/// What holds the mass, and which records end with it held or moving.
void add_rest(Section& answer, const design::RecordDesign& result);
void add_records(Document& document, const design::RecordDesign& result, const Physical& physical);
/// Which records lock the mass; empty if none.
[[nodiscard]] std::string lock_words(const design::RecordDesign& result);

/// Whether its figures are means of several records.
[[nodiscard]] bool is_mean(const design::RecordDesignRequest& task);

/// "f and delta", or the one that can be off: a zero stays zero.
[[nodiscard]] std::string_view inexact_parts(const design::RecordDesign& result);
/// Within the tolerance, more than a quarter of the dampers fail, or one is much worse.
[[nodiscard]] bool is_delicate(const design::RecordDesign& result);
/// What a damper that is not built exactly may do; empty without a tolerance.
[[nodiscard]] std::string tolerance_sentence(const design::RecordDesign& result,
                                             const Physical& physical);
/// The samples, the nearest damper that is much worse, and the decision margin.
void add_tolerance(Section& answer, const design::RecordDesign& result, const Physical& physical);

/// Of a design: as many as it was rounded to, or almost every digit that it has.
inline constexpr int printed_digits = 12;

/// Whether its stroke pulls the mass back with less than a thousandth of the load.
[[nodiscard]] bool hardly_moves(const design::RecordDesign& result);

}  // namespace stillpoint::report
