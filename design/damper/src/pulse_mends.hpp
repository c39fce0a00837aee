// SPDX-License-Identifier: MIT
#pragma once

#include <stillpoint/design/pulse.hpp>
#include <stillpoint/design/region.hpp>

#include <optional>
#include <vector>

namespace stillpoint::design {

/// Like mends() of region.hpp, with k and lambda instead of v0.
[[nodiscard]] std::vector<Mend> mends(const PulseProblem& problem, const Limits& limits);
[[nodiscard]] std::optional<JointMend> joint_mend(const PulseProblem& problem,
                                                  const Limits& limits);

}  // namespace stillpoint::design
