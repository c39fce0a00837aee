// SPDX-License-Identifier: MIT
#pragma once

#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

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

/// Opens a new file, with the permissions that the mask of the process leaves; -1 and errno if
/// there is one, or even a link, under that name.
[[nodiscard]] int create_file(const std::string& path);

/// Writes everything; returns 0 or the errno.
[[nodiscard]] int write_all(int descriptor, std::string_view text);
[[nodiscard]] int write_and_close(int descriptor, std::string_view text);

/// Waits until the disk has what a directory says of the file: its name, after a rename. Returns 0
/// or the errno.
[[nodiscard]] int synchronize_name(const std::string& path);

/// Whether the path leads to the same file as standard output.
[[nodiscard]] bool is_standard_output(const std::string& path);

/// Whether the path leads to something other than a regular file: a device, a pipe.
[[nodiscard]] bool is_special_file(const std::string& path);

/// Where a chain of links leads; that file need not exist.
[[nodiscard]] std::filesystem::path behind_links(std::filesystem::path path);

/// Whether both lead to the same file; files that do not exist yet are compared by name.
[[nodiscard]] bool same_file(const std::string& a, const std::string& b);

/// A file as messages name it; `path` "-" is standard input or output.
struct NamedFile {
  std::string field;
  std::string path;
};

/// Throws records::FileError if a file that would be written is also read, or would be written
/// twice. Links are followed; a device or a pipe may be written to any number of times.
void require_apart(const std::vector<NamedFile>& inputs, const std::vector<NamedFile>& outputs);

}  // namespace stillpoint::sweep
