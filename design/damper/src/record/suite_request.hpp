// SPDX-License-Identifier: MIT
#pragma once

#include <stillpoint/design/suite_task.hpp>

namespace stillpoint::design {

/// Throws InputError.
void require_valid(const RecordDesignRequest& request);

/// A valid request with the ranges and the combination that it leaves open. Throws InputError.
[[nodiscard]] RecordDesignRequest completed(RecordDesignRequest request);

}  // namespace stillpoint::design
