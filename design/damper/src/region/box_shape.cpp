// SPDX-License-Identifier: MIT
#include <stillpoint/design/box_shape.hpp>

#include <stillpoint/core/input_error.hpp>

#include <fmt/format.h>

#include <algorithm>

namespace stillpoint::design {

Spread spread_of_tolerance(const std::string& field, double tolerance) {
  if (!(tolerance >= 0 && tolerance < 1)) {
    throw InputError(field, tolerance, "must be at least 0 and less than 1 (0.1 is 10 %)");
  }
  return {tolerance, tolerance};
}

Spread spread_of_factors(const std::string& field, double low, double high) {
  if (!(low > 0 && low <= 1 && high >= 1 && high < 2)) {
    throw InputError(field, fmt::format("{}:{}", low, high),
                     "must be factors LOW:HIGH with 0 < LOW <= 1 <= HIGH < 2");
  }
  return {1 - low, high - 1};
}

void shape_box(Limits& limits, const std::optional<Spread>& of_f,
               const std::optional<Spread>& of_delta) {
  if (!of_f && !of_delta) {
    return;
  }
  const Spread both{limits.tolerance, limits.tolerance};
  const Spread f = of_f.value_or(both);
  const Spread delta = of_delta.value_or(both);
  const double most = std::max({f.below, f.above, delta.below, delta.above});
  if (!(most > 0)) {
    throw InputError(of_f ? "tolerance-f" : "tolerance-delta", 0.0,
                     "must be above 0 if there is no other tolerance");
  }
  limits.tolerance = most;
  limits.shape = {f.below / most, f.above / most, delta.below / most, delta.above / most};
}

}  // namespace stillpoint::design
