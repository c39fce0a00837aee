// SPDX-License-Identifier: MIT
#pragma once

// The parts of the document of a design under records.

#include "sections.hpp"

#include <stillpoint/design/record_design.hpp>

#include <cstddef>
#include <string>

namespace stillpoint::report {

/// "the record", "every record", "1 of 2 records"
[[nodiscard]] std::string of_records(std::size_t count, std::size_t all);

[[nodiscard]] std::string figure_shown(const Physical& physical, design::SuiteObjective which,
                                       double value);

/// If the design has the paper's notch: what one of the example width spoils, in a sentence; empty
/// if nothing.
[[nodiscard]] std::string example_sentence(const design::RecordDesign& result,
                                           const Physical& physical);
/// In that case, what the mass feels in a notch with a width, and how wide it must be.
void add_example(Section& answer, const design::RecordDesign& result, const Physical& physical);

}  // namespace stillpoint::report
