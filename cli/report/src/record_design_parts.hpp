// SPDX-License-Identifier: MIT
#pragma once

// What the text and the figures of a design under records share.

#include "sections.hpp"

#include <stillpoint/core/simulation.hpp>
#include <stillpoint/design/record_design.hpp>

#include <cstddef>

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

}  // namespace stillpoint::report
