// SPDX-License-Identifier: MIT
#pragma once

#include "pulse/first_return.hpp"

#include <stillpoint/design/pulse.hpp>

namespace stillpoint::design {

/// The pulse in units of k and p.
[[nodiscard]] Pulse unit_pulse(const Pulse& pulse, double p);

/// One run of the pulse with that f, in units of k and p; the pulse is in its own units.
[[nodiscard]] FirstReturn first_return(const Pulse& pulse, double p, double f);

}  // namespace stillpoint::design
