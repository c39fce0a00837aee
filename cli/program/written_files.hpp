// SPDX-License-Identifier: MIT
#pragma once

#include "options/settings.hpp"

#include <optional>
#include <string>

namespace stillpoint::cli {

/// Throws records::FileError if a file that `command` would write is one that it reads (scene,
/// record, list), is to be written twice, or belongs to a sweep that is running. Links are
/// followed; a device or a pipe may be written to any number of times. `scene` is a path, or "-"
/// for standard input.
void require_files_apart(Command command, const Settings& settings,
                         const std::optional<std::string>& scene);

}  // namespace stillpoint::cli
