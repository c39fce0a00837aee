// SPDX-License-Identifier: MIT
#pragma once

#include <filesystem>
#include <string>
#include <string_view>

namespace stillpoint::cli {

/// Throws UsageError "FIELD PATH: cannot be written: ..." for an errno.
[[noreturn]] void refuse_writing(std::string_view field, const std::string& path, int error);

/// Throws UsageError where `path` cannot be meant as a file's name: it is empty, "-" or a
/// directory.
void require_file_name(std::string_view field, const std::string& path);

/// Writes everything; 0 or the error.
[[nodiscard]] int write_all(int descriptor, std::string_view text);

/// Whether the path leads to what standard output is.
[[nodiscard]] bool is_standard_output(const std::string& path);

/// Whether something is there that is no regular file: a device, a pipe.
[[nodiscard]] bool is_special_file(const std::string& path);

/// Where a chain of links leads, to a file that may not exist yet.
[[nodiscard]] std::filesystem::path behind_links(std::filesystem::path path);

}  // namespace stillpoint::cli
