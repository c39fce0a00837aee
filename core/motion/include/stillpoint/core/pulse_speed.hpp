// SPDX-License-Identifier: MIT
#pragma once

#include <stillpoint/core/excitation.hpp>

#include <optional>

namespace stillpoint {

/// The free motion that stands for a short pulse: it leaves x = 0 at `tau` with `speed`.
struct EquivalentStart {
  double speed{0};  ///< > 0
  double tau{0};    ///< since the start of the pulse; without friction the pulse's centroid
};

/// The start from which a free motion under friction f comes to the end of the pulse as the pulse
/// leaves the mass there, to second order in p / lambda: docs/forced.md section 8. Friction already
/// takes its part during the pulse. Empty where the mass never moves, |k| <= f. Throws InputError
/// as require_valid does, and unless f >= 0.
[[nodiscard]] std::optional<EquivalentStart> equivalent_start(const HalfSine& pulse, double f);
[[nodiscard]] std::optional<EquivalentStart> equivalent_start(const Rectangle& pulse, double f);

}  // namespace stillpoint
