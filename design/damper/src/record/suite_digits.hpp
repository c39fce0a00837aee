// SPDX-License-Identifier: MIT
#pragma once

#include "record/suite.hpp"

#include <vector>

namespace stillpoint::design {

/// The dampers next to one whose searched values have so many digits in the units of
/// `task.printed`.
[[nodiscard]] std::vector<SuiteDamper> neighbours_of_digits(const RecordDesignRequest& task,
                                                            const SuiteDamper& damper, int digits);

}  // namespace stillpoint::design
