// SPDX-License-Identifier: MIT
#pragma once

#include "request.hpp"

#include <stillpoint/core/free_motion.hpp>

#include <string>

namespace stillpoint::cli {

/// tau,x,v, and with physical input t_s,x_m,v_m_per_s, at evenly spaced instants and every event. A
/// passage has two lines, before and after the notch. Ends with the motion, or at t_end; where
/// neither exists, after ten periods.
[[nodiscard]] std::string trajectory_csv(const SimulateInput& input, const Response& response);

}  // namespace stillpoint::cli
