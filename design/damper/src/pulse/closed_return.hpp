// SPDX-License-Identifier: MIT
#pragma once

// The first return under a pulse without a search for events: docs/theory.md section 16. In units
// of k and p, as first_return.hpp.

#include "pulse/first_return.hpp"

#include <stillpoint/design/pulse.hpp>

#include <optional>

namespace stillpoint::design {

/// The motion under the unit pulse with friction f < 1; empty for a full sine that is very short,
/// whose speed is a small difference. Accurate to a few roundings, except for what an f barely
/// below 1 amplifies.
[[nodiscard]] std::optional<FirstReturn> closed_return(const Pulse& pulse, double f);

}  // namespace stillpoint::design
