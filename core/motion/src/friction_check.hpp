// SPDX-License-Identifier: MIT
#pragma once

#include <string>

namespace stillpoint {

/// A friction, or the load that a notch holds: throws InputError, naming the field, unless it is 0
/// or f / p is within the bounds of oscillator.hpp.
void require_friction(const std::string& field, double f, double p);

}  // namespace stillpoint
