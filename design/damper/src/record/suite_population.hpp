// SPDX-License-Identifier: MIT
#pragma once

#include "record/suite_points.hpp"

#include <vector>

namespace stillpoint::design {

/// The best of each population that is bred from `found` and from points about `best`.
[[nodiscard]] std::vector<RankedPoint> bred(SuitePoints& points,
                                            const std::vector<RankedPoint>& found,
                                            const RankedPoint& best);

}  // namespace stillpoint::design
