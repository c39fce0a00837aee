// SPDX-License-Identifier: MIT
#pragma once

#include "record/suite_points.hpp"

#include <string>
#include <vector>

namespace stillpoint::design {

/// A search by NLopt.
struct SuiteDescent {
  RankedPoint best;  ///< that it tried, the start included
  const char* algorithm;
  std::string status;  ///< NLopt's own
  int evaluations{0};
};

/// From each start, with this first step. If asked, a global search comes first, which takes
/// longest, with a descent from its best.
[[nodiscard]] std::vector<SuiteDescent> descents(const SuitePoints& points,
                                                 const std::vector<RankedPoint>& starts,
                                                 double first_step, bool global);

}  // namespace stillpoint::design
