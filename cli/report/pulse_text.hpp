// SPDX-License-Identifier: MIT
#pragma once

#include "page.hpp"
#include "request.hpp"

#include <stillpoint/design/pulse.hpp>
#include <stillpoint/design/pulse_check.hpp>

#include <optional>

namespace stillpoint::cli {

/// The pulse that was asked for, among the rows of the task.
void add_pulse(Page& page, const design::Pulse& pulse,
               const std::optional<design::PhysicalInput>& physical);

/// How the design stands under the pulse itself.
void add_pulse_check(Page& page, const design::PulseCheck& check,
                     const std::optional<design::PhysicalInput>& physical);

}  // namespace stillpoint::cli
