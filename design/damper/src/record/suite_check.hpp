// SPDX-License-Identifier: MIT
#pragma once

#include "record/suite.hpp"

#include <stillpoint/design/cross_check.hpp>

#include <vector>

namespace stillpoint::design {

/// The motions of a damper under each record by another integrator.
[[nodiscard]] CrossCheck check(const Suite& suite, const SuiteDamper& damper,
                               const std::vector<ForcedResponse>& responses);

}  // namespace stillpoint::design
