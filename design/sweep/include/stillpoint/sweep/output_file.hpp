// SPDX-License-Identifier: MIT
#pragma once

#include <filesystem>
#include <string>
#include <string_view>

namespace stillpoint::sweep {

/// Throws records::FileError "FIELD PATH: cannot be written: ..." for an errno.
[[noreturn]] void refuse_writing(std::string_view field, const std::string& path, int error);

/// Throws InputError if `path` is empty or "-", and FileError if it is a directory.
void require_file_name(std::string_view field, const std::string& path);

/// Makes a directory and its parents. Throws InputError if `path` is empty, FileError if it cannot
/// be made.
void make_directory(std::string_view field, const std::string& path);

/// Throws FileError unless the directory of the file exists.
void require_directory_of(std::string_view field, const std::string& path);

/// Writes everything; returns 0 or the errno.
[[nodiscard]] int write_all(int descriptor, std::string_view text);

/// Whether the path leads to the same file as standard output.
[[nodiscard]] bool is_standard_output(const std::string& path);

/// Whether the path leads to something other than a regular file: a device, a pipe.
[[nodiscard]] bool is_special_file(const std::string& path);

/// Where a chain of links leads; that file need not exist.
[[nodiscard]] std::filesystem::path behind_links(std::filesystem::path path);

/// Whether both lead to the same file; files that do not exist yet are compared by name.
[[nodiscard]] bool same_file(const std::string& a, const std::string& b);

/// Whether the path is FILE.part or FILE.part.json of a sweep that is alive and holds a lock on the
/// former.
[[nodiscard]] bool is_being_swept(const std::string& path);

}  // namespace stillpoint::sweep
