// SPDX-License-Identifier: MIT
#pragma once

#include "options/settings.hpp"

namespace stillpoint::cli {

/// Reads a scene: a JSON object, which may have comments, whose keys are option names ('-' and '_'
/// are the same). `path` "-" is standard input. The files that it names are those beside it, or
/// else in the working directory. Throws records::FileError for a file that cannot be read, is
/// larger than 1 MiB or is not valid JSON, for an unknown key and for a value of the wrong type for
/// `command`.
[[nodiscard]] Settings read_scene(const std::string& path, Command command);

/// The same from text; `source` names it in messages.
[[nodiscard]] Settings parse_scene(std::string_view text, std::string_view source, Command command);

/// The same from a JSON object. Throws InputError and UsageError.
[[nodiscard]] Settings scene_settings(const nlohmann::json& scene, Command command);

/// The settings of `command`: the flags, and what they leave of the scene. A flag overrides its own
/// key and removes the keys that it excludes: --velocity removes v0 and pulse, --record an
/// excitation. A pulse is the hit of a design and the excitation of a motion; other commands do not
/// use it.
///
/// Removes from `scene` the keys that the flags override. Throws InputError and UsageError for a
/// wrong pulse.
[[nodiscard]] Settings scene_and_flags(Command command, const Settings& flags, Settings& scene);

}  // namespace stillpoint::cli
