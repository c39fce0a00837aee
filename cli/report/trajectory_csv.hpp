// SPDX-License-Identifier: MIT
#pragma once

#include "json_report.hpp"
#include "request.hpp"

#include <functional>
#include <string>

namespace stillpoint::cli {

/// Up to when a forced motion must be followed: t_end, else until its rest is known to be the final
/// one; where it never stops after its excitation, ten periods more.
[[nodiscard]] double forced_horizon(const SimulateInput& input, const ForcedResponse& response);

/// tau,x,v, and with physical input t_s,x_m,v_m_per_s, at evenly spaced instants and every event. A
/// passage has two lines, before and after the notch. Ends with the motion, or at t_end; where
/// neither exists, after ten periods.
[[nodiscard]] std::string free_trajectory_csv(const SimulateInput& input, const Response& response);

/// The same up to `horizon`, or without t_end to the final rest; `go_on` as in ForcedOptions.
[[nodiscard]] std::string forced_trajectory_csv(const SimulateInput& input, double horizon,
                                                const std::function<bool(double)>& go_on);

}  // namespace stillpoint::cli
