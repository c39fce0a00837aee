// SPDX-License-Identifier: MIT
#pragma once

#include <string>

namespace stillpoint {

/// Of a friction, or of the load that a notch holds: throws InputError unless `f` is 0 or f / p is
/// within [smallest_friction_speed, largest_speed]. `symbol` is its name in formulas.
void require_friction(const std::string& field, const char* symbol, double f, double p);

}  // namespace stillpoint
