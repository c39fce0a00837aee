// SPDX-License-Identifier: MIT
#pragma once

#include <string>

namespace stillpoint::report {

/// "tau 3 of 10, 30 %"; `end` is 0 if that is not known.
[[nodiscard]] std::string progress_in_tau(double tau, double end);

/// ", 0:50 left"
[[nodiscard]] std::string time_left(double seconds);

}  // namespace stillpoint::report
