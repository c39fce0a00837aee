// SPDX-License-Identifier: MIT
#include <stillpoint/sweep/output_file.hpp>

#include <stillpoint/core/input_error.hpp>
#include <stillpoint/records/file_error.hpp>

#include <fmt/format.h>

#include <sys/stat.h>
#include <unistd.h>

#include <cerrno>
#include <cstring>
#include <system_error>

namespace stillpoint::sweep {

void refuse_writing(std::string_view field, const std::string& path, int error) {
  throw records::FileError({.kind = std::string(field), .path = path},
                           fmt::format("cannot be written: {}", std::strerror(error)));
}

void require_file_name(std::string_view field, const std::string& path) {
  if (path.empty() || path == "-") {
    throw InputError(std::string(field), path.empty() ? "\"\"" : path,
                     "must be the name of a file");
  }
  std::error_code unknown;
  if (std::filesystem::is_directory(path, unknown)) {
    refuse_writing(field, path, EISDIR);
  }
  if (std::filesystem::is_symlink(behind_links(path), unknown)) {
    refuse_writing(field, path, ELOOP);
  }
}

int write_all(int descriptor, std::string_view text) {
  while (!text.empty()) {
    const ssize_t written = ::write(descriptor, text.data(), text.size());
    if (written >= 0) {
      text.remove_prefix(static_cast<std::size_t>(written));
    } else if (errno != EINTR) {
      return errno;
    }
  }
  return 0;
}

bool is_standard_output(const std::string& path) {
  struct stat file {};
  struct stat standard {};
  return ::stat(path.c_str(), &file) == 0 && ::fstat(STDOUT_FILENO, &standard) == 0 &&
         file.st_dev == standard.st_dev && file.st_ino == standard.st_ino;
}

bool is_special_file(const std::string& path) {
  std::error_code unknown;
  const auto status = std::filesystem::status(path, unknown);
  return std::filesystem::exists(status) && !std::filesystem::is_regular_file(status);
}

std::filesystem::path behind_links(std::filesystem::path path) {
  constexpr int longest_chain = 40;  // as Linux follows
  std::error_code none;
  for (int i = 0; i < longest_chain && std::filesystem::is_symlink(path, none); ++i) {
    path = path.parent_path() / std::filesystem::read_symlink(path, none);
  }
  return path;
}

}  // namespace stillpoint::sweep
