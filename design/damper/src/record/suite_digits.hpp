// SPDX-License-Identifier: MIT
#pragma once

#include "record/suite.hpp"

namespace stillpoint::design {

/// The best damper with the fewest digits, in the units of `task.printed`, that is next to `found`
/// and not worse by more than 1e-5, nor farther from the limits; `found` itself if there is none.
[[nodiscard]] SuitePoint with_few_digits(const Suite& suite, const RecordDesignRequest& task,
                                         const SuitePoint& found);

}  // namespace stillpoint::design
