// SPDX-License-Identifier: MIT
#pragma once

#include <stillpoint/core/excitation.hpp>

#include <optional>

namespace stillpoint {

/// The free motion that replaces a short pulse: it leaves x = 0 at `tau` with `speed`.
struct EquivalentStart {
  double speed{0};  ///< > 0
  double tau{0};    ///< since the start of the pulse; without friction the pulse's centroid
};

/// The start of the free motion under friction f that is in the same state at the end of the pulse
/// as the mass, to second order in p / lambda: docs/forced.md section 8. Friction already acts
/// during the pulse. Empty if the mass never moves, |k| <= f. Throws InputError as require_valid
/// does, and unless f >= 0.
[[nodiscard]] std::optional<EquivalentStart> equivalent_start(const HalfSine& pulse, double f);
[[nodiscard]] std::optional<EquivalentStart> equivalent_start(const Rectangle& pulse, double f);

}  // namespace stillpoint
