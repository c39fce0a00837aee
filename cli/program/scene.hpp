// SPDX-License-Identifier: MIT
#pragma once

#include "settings.hpp"

#include <string>
#include <string_view>

namespace stillpoint::cli {

/// Reads a scene: a JSON object whose keys are option names ('-' and '_' are the same). `path` "-"
/// is standard input. Throws records::FileError for a file that cannot be read, is larger than 1
/// MiB or is not valid JSON, and InputError for an unknown key and for a value of the wrong type
/// for `command`.
[[nodiscard]] Settings read_scene(const std::string& path, Command command);

/// The same from text; `source` names it in messages.
[[nodiscard]] Settings parse_scene(std::string_view text, std::string_view source, Command command);

}  // namespace stillpoint::cli
