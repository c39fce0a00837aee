// SPDX-License-Identifier: MIT
#pragma once

// What a design under records must say beyond its figures.

#include <stillpoint/design/finding.hpp>
#include <stillpoint/design/record_design_result.hpp>

#include <vector>

namespace stillpoint::design {

/// Of an answer that is complete but for them, to the request as it was given.
[[nodiscard]] std::vector<Finding> findings_of(const RecordDesign& result,
                                               const RecordDesignRequest& asked);

/// A damper that transmits more than 95 % of the load does not isolate.
[[nodiscard]] bool isolates(const RecordDesign& result);

/// Whether its figures are means of several records.
[[nodiscard]] bool is_mean(const LoadCase& load_case);

}  // namespace stillpoint::design
