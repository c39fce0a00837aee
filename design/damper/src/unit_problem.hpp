// SPDX-License-Identifier: MIT
#pragma once

// The problem with one parameter left: docs/theory.md section 7. In units of V0 and p
//
// | here  | paper         |                                           |
// |-------|---------------|-------------------------------------------|
// | a     | f / (V0 p)    | constant friction                         |
// | d     | Delta / V0^2  | point friction                            |
// | b     | beta p / V0   | admissible displacement                   |
// | s     | S / (V0 p)    | sqrt(1 + a^2), the peak acceleration      |
//
// Nine decades of V0, p and beta all become numbers of order one here.

#include <stillpoint/design/problem.hpp>

#include <numbers>

namespace stillpoint::design::unit {

/// f3: the largest friction with a return to x = 0, 1/sqrt(8).
inline constexpr double a3 = std::numbers::sqrt2 / 4;
/// Delta2: the largest point friction that lets the motion start.
inline constexpr double d2 = 0.5;

[[nodiscard]] double radius(double a);  ///< s

/// Delta1 / V0^2 for 0 <= a <= a3, (26) or (27); decreasing in a.
[[nodiscard]] double delta1(Criterion criterion, double a);
[[nodiscard]] double delta1_slope(Criterion criterion, double a);
[[nodiscard]] double peak(double a);        ///< p A / V0, (24)
[[nodiscard]] double peak_slope(double a);  ///< its derivative
/// p T for 0 <= a <= a3, (25). The slope grows without bound towards a3 and is cut at 1e8 there.
[[nodiscard]] double stop_phase(double a);
[[nodiscard]] double stop_phase_slope(double a);
/// v_- / V0 for 0 <= a <= a3.
[[nodiscard]] double arrival_speed(double a);

}  // namespace stillpoint::design::unit
