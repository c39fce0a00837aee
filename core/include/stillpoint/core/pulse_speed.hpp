// SPDX-License-Identifier: MIT
#pragma once

#include <stillpoint/core/excitation.hpp>

namespace stillpoint {

/// The speed from which a free motion under friction f has the first peak that the pulse causes, to
/// second order in p / lambda: docs/forced.md section 8. It is that of an energy: friction already
/// takes its part during the pulse. 0 where |k| <= f, which moves nothing. Throws InputError as
/// require_valid does, and unless f >= 0.
[[nodiscard]] double equivalent_speed(const HalfSine<>& pulse, double f);
[[nodiscard]] double equivalent_speed(const Rectangle<>& pulse, double f);

}  // namespace stillpoint
