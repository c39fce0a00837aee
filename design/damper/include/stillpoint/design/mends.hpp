// SPDX-License-Identifier: MIT
#pragma once

#include <stillpoint/design/problem.hpp>
#include <stillpoint/design/region_result.hpp>

#include <optional>
#include <vector>

namespace stillpoint::design {

/// One entry for each input that suffices alone; none if the region is not empty.
[[nodiscard]] std::vector<Mend> mends(const Problem& problem, const Limits& limits);

/// Empty if the region is not empty, or if one input suffices.
[[nodiscard]] std::optional<JointMend> joint_mend(const Problem& problem, const Limits& limits);

}  // namespace stillpoint::design
