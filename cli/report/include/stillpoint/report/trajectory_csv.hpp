// SPDX-License-Identifier: MIT
#pragma once

#include <stillpoint/core/state.hpp>
#include <stillpoint/design/physical.hpp>

#include <optional>
#include <string>
#include <vector>

namespace stillpoint::report {

/// tau,x,v, and with physical input t_s,x_m,v_m_per_s, a line for each state.
[[nodiscard]] std::string trajectory_csv(const std::vector<State>& states,
                                         const std::optional<design::PhysicalInput>& physical);

}  // namespace stillpoint::report
