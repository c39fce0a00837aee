// SPDX-License-Identifier: MIT
#pragma once

#include <stillpoint/design/suite_task.hpp>

namespace stillpoint::design {

/// With every load times that factor.
[[nodiscard]] RecordDesignRequest enlarged(RecordDesignRequest task, double factor);

/// Of a completed request and a damper with `scale` times its tolerance.
[[nodiscard]] SuiteOutlook outlook(const RecordDesignRequest& task, const SuiteDamper& damper,
                                   double scale);

}  // namespace stillpoint::design
