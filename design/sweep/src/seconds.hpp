// SPDX-License-Identifier: MIT
#pragma once

#include <chrono>

namespace stillpoint::sweep {

/// Of a clock that only goes forward.
[[nodiscard]] inline double seconds_now() {
  const auto now = std::chrono::steady_clock::now().time_since_epoch();
  return std::chrono::duration<double>(now).count();
}

}  // namespace stillpoint::sweep
