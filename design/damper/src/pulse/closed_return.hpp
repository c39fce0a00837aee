// SPDX-License-Identifier: MIT
#pragma once

// The first return under a pulse without a search for events: docs/theory.md section 16. In units
// of k and p, as profile.hpp.

#include "pulse/profile.hpp"

#include <optional>

namespace stillpoint::design {

/// The motion under the unit pulse with friction f < 1; empty where it is not known beforehand in
/// which order the load turns the mass: a half-sine with lambda < 1/2 and a full sine with
/// lambda < 1, where the mass may swing more than once while the pulse lasts, and a full sine that
/// turns the mass twice or is very short. Good to a few roundings, but for what f hardly below 1
/// magnifies.
[[nodiscard]] std::optional<FirstReturn> closed_return(const Pulse& pulse, double f);

}  // namespace stillpoint::design
