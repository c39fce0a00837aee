// SPDX-License-Identifier: MIT
#pragma once

#include <chrono>

namespace stillpoint {

/// The reading of a monotonic clock; a duration is the difference of two calls.
[[nodiscard]] inline double seconds_now() {
  const auto now = std::chrono::steady_clock::now().time_since_epoch();
  return std::chrono::duration<double>(now).count();
}

}  // namespace stillpoint
