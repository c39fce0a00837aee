// SPDX-License-Identifier: MIT
#pragma once

#include "record/suite.hpp"

#include <stillpoint/design/cross_check.hpp>

#include <vector>

namespace stillpoint::design {

/// The motions of a damper in each case by another integrator.
[[nodiscard]] CrossCheck check(const Suites& suites, const SuiteDamper& damper,
                               const std::vector<std::vector<ForcedResponse>>& responses);

}  // namespace stillpoint::design
