// SPDX-License-Identifier: MIT
#pragma once

#include "settings.hpp"

#include <optional>
#include <string>

namespace stillpoint::cli {

/// Throws UsageError, naming both, where a file that `command` would write is one that it reads
/// (scene, record, list) or is to be written twice. Links are followed; a device or a pipe may be
/// written to as often as one likes. `scene` is a path, or "-" for standard input.
void require_files_apart(Command command, const Settings& settings,
                         const std::optional<std::string>& scene);

}  // namespace stillpoint::cli
