// SPDX-License-Identifier: MIT
#pragma once

#include "options/settings.hpp"

#include <stillpoint/sweep/output_file.hpp>

#include <optional>
#include <string>
#include <vector>

namespace stillpoint::cli {

/// The scene, a path or "-" for standard input, and the files that the options name. Throws
/// UsageError if two of them are standard input.
[[nodiscard]] std::vector<sweep::NamedFile> files_to_read(Command command, const Settings& settings,
                                                          const std::optional<std::string>& scene);

/// Throws records::FileError if a file that `command` would write is one that it reads, or is to be
/// written twice. Links are followed; a device or a pipe may be written to any number of times.
void require_files_apart(Command command, const Settings& settings,
                         const std::optional<std::string>& scene);

}  // namespace stillpoint::cli
