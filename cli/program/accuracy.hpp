// SPDX-License-Identifier: MIT
#pragma once

#include "request.hpp"

#include <stillpoint/peers/comparison.hpp>

#include <string>

namespace stillpoint::cli {

/// How each method does on one scene.
struct AccuracyAnswer {
  peers::Comparison comparison;
  std::string why;  ///< simulate uses the first
};

/// Throws UsageError for a motion that never stops and one that is too long for 50 digits.
[[nodiscard]] AccuracyAnswer compare_methods(const SimulateInput& input);

}  // namespace stillpoint::cli
