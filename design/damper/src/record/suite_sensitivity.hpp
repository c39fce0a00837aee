// SPDX-License-Identifier: MIT
#pragma once

#include "record/suite.hpp"

#include <stillpoint/design/suite_sensitivity.hpp>

namespace stillpoint::design {

/// For a completed request.
[[nodiscard]] Sensitivity sensitivity(const Suite& suite, const RecordDesignRequest& request,
                                      const SuitePoint& chosen);

}  // namespace stillpoint::design
