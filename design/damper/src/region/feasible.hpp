// SPDX-License-Identifier: MIT
#pragma once

#include <stillpoint/design/region_result.hpp>

namespace stillpoint::design {

/// What f and Delta are feasible, for an answer whose region and strips are known.
void add_feasible(RegionAnswer& answer, const RegionRequest& request);

}  // namespace stillpoint::design
