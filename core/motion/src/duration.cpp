// SPDX-License-Identifier: MIT
#include "kernel/excitation_run.hpp"

#include <cmath>
#include <variant>

namespace stillpoint {

std::optional<double> duration(const Excitation& excitation) {
  const double lasts =
      std::visit([](const auto& kind) { return duration_of<double>(kind); }, excitation);
  return std::isfinite(lasts) ? std::optional(lasts) : std::nullopt;
}

}  // namespace stillpoint
