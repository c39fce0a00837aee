// SPDX-License-Identifier: MIT
#pragma once

#include "settings.hpp"

namespace stillpoint::cli {

/// What `command` is to do: the flags, and what they leave of the scene. A flag overrides its own
/// key and removes the keys that it excludes: --velocity removes v0 and pulse, --record an
/// excitation. A pulse is the hit of a design and the excitation of a motion; other commands do not
/// use it.
///
/// Removes from `scene` what gave way. Throws InputError and UsageError for a wrong pulse.
[[nodiscard]] Settings scene_and_flags(Command command, const Settings& flags, Settings& scene);

}  // namespace stillpoint::cli
