// SPDX-License-Identifier: MIT
#include "kernel/excitation_law.hpp"

#include <cmath>
#include <optional>

namespace stillpoint {

std::optional<double> duration(const Excitation& excitation) {
  const double lasts =
      std::visit([](const auto& kind) { return duration_of<double>(kind); }, excitation);
  return std::isfinite(lasts) ? std::optional(lasts) : std::nullopt;
}

std::function<double(const ExactSum<double>&, const ExactSum<double>&)> load_while_held(
    const Excitation& excitation, double p) {
  return largest_load_of(excitation, p);
}

}  // namespace stillpoint
