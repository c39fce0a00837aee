// SPDX-License-Identifier: MIT
#pragma once

#include <stillpoint/design/part.hpp>
#include <stillpoint/design/pulse_request.hpp>

#include <span>

namespace stillpoint::design {

/// `choose` under a pulse.
[[nodiscard]] Choice choose_under_pulse(const PulseRequest& request, std::span<const Part> parts);

}  // namespace stillpoint::design
