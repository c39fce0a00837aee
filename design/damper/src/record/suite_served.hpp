// SPDX-License-Identifier: MIT
#pragma once

#include "record/suite.hpp"

#include <stillpoint/design/works_for.hpp>

#include <optional>

namespace stillpoint::design {

/// The factors on all loads, and the p of the spring, about the given ones that leave every limit
/// of a completed request kept by the damper itself; looked for in steps of one per cent, the loads
/// from a tenth to ten times, p from half to twice. Empty if it breaks one as it is.
[[nodiscard]] std::optional<WorksFor> works_for(const RecordDesignRequest& request,
                                                const SuiteDamper& damper);

}  // namespace stillpoint::design
