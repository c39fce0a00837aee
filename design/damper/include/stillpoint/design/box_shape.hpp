// SPDX-License-Identifier: MIT
#pragma once

#include <stillpoint/core/interval.hpp>
#include <stillpoint/design/problem.hpp>

#include <optional>
#include <string>

namespace stillpoint::design {

/// How far a friction may fall and rise, as parts of it.
struct Spread {
  double below{0};
  double above{0};
};
[[nodiscard]] constexpr Spread times(const Spread& spread, double scale) {
  return {spread.below * scale, spread.above * scale};
}
/// Of a value that may be off by both.
[[nodiscard]] constexpr Spread combined(const Spread& one, const Spread& other) {
  return {1 - (1 - one.below) * (1 - other.below), (1 + one.above) * (1 + other.above) - 1};
}

/// The dampers that the tolerance of a damper allows.
struct DamperBox {
  Interval f;
  Interval delta;
};
[[nodiscard]] constexpr DamperBox box_about(const DesignPoint& damper, const BoxShape& shape) {
  const auto& [f, delta, r] = damper;
  return {{f * (1 - r * shape.f_low), f * (1 + r * shape.f_high)},
          {delta * (1 - r * shape.delta_low), delta * (1 + r * shape.delta_high)}};
}
/// With what may be used of its tolerance: what was asked for, else all that it has.
[[nodiscard]] constexpr DesignPoint granted(DesignPoint damper, const Limits& limits) {
  damper.tolerance = limits.tolerance > 0 ? limits.tolerance : damper.tolerance;
  return damper;
}

/// Each throws InputError, naming `field`: for R unless 0 <= R < 1, for the factors LOW:HIGH unless
/// 0 < LOW <= 1 <= HIGH < 2.
[[nodiscard]] Spread spread_of_tolerance(const std::string& field, double tolerance);
[[nodiscard]] Spread spread_of_factors(const std::string& field, double low, double high);

/// Sets the sides of the limits' box; an absent one is limits.tolerance. Throws InputError if all
/// are 0.
void shape_box(Limits& limits, const std::optional<Spread>& of_f,
               const std::optional<Spread>& of_delta);

}  // namespace stillpoint::design
