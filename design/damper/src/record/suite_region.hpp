// SPDX-License-Identifier: MIT
#pragma once

// Which dampers meet every limit: on maps of f and delta with samples of each box, whose edges are
// halved.

#include "record/suite.hpp"

#include <stillpoint/design/record_design_result.hpp>

namespace stillpoint::design {

/// Of a completed request.
[[nodiscard]] FeasibleRegion feasible_region(const Suites& suites, const RecordDesignRequest& task);

}  // namespace stillpoint::design
