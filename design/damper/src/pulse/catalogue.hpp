// SPDX-License-Identifier: MIT
#pragma once

#include <stillpoint/design/part.hpp>

#include <span>

namespace stillpoint::design {

/// `choose` for a pulse.
[[nodiscard]] Choice choose_under_pulse(const PulseRequest& request, std::span<const Part> parts);

}  // namespace stillpoint::design
