// SPDX-License-Identifier: MIT
#pragma once

#include "settings.hpp"

namespace stillpoint::cli {

/// What `command` is to do: the flags, and of the scene what they leave. A flag overrides its own
/// key and displaces what excludes it: --velocity a v0 or a pulse, --record an excitation. A pulse
/// is for design the start, for motions the excitation, and for others nothing.
///
/// Takes from `scene` what was displaced. Throws InputError and UsageError for a wrong pulse.
[[nodiscard]] Settings scene_and_flags(Command command, const Settings& flags, Settings& scene);

}  // namespace stillpoint::cli
