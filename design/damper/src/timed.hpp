// SPDX-License-Identifier: MIT
#pragma once

#include <chrono>

namespace stillpoint::design {

/// Runs it and returns how long that took, in seconds.
template <class Run>
double timed(const Run& run) {
  const auto started = std::chrono::steady_clock::now();
  run();
  return std::chrono::duration<double>(std::chrono::steady_clock::now() - started).count();
}

}  // namespace stillpoint::design
