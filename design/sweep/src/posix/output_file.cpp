// SPDX-License-Identifier: MIT
#include <stillpoint/sweep/output_file.hpp>

#include <stillpoint/core/input_error.hpp>
#include <stillpoint/records/file_error.hpp>

#include <fmt/format.h>

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cerrno>
#include <cstring>
#include <system_error>

namespace stillpoint::sweep {

namespace {

std::filesystem::path resolved_place(const std::string& path) {
  std::error_code unreachable;
  const auto whole = std::filesystem::absolute(behind_links(path), unreachable);
  auto resolved = std::filesystem::weakly_canonical(whole, unreachable);
  return unreachable ? whole.lexically_normal() : resolved;
}

/// Invalid names are refused where the file is written.
bool may_be_a_file(const NamedFile& output) {
  return !output.path.empty() && output.path != "-" && !is_special_file(output.path);
}

bool is_one_file(const NamedFile& a, const NamedFile& b) {
  return same_file(a.path == "-" ? "/dev/stdin" : a.path, b.path);
}

std::string shown(const NamedFile& file) {
  return fmt::format("{} {}", file.field, file.path == "-" ? "on standard input" : file.path);
}

}  // namespace

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

void make_directory(std::string_view field, const std::string& path) {
  if (path.empty()) {
    throw InputError(std::string(field), "\"\"", "must be the name of a directory");
  }
  std::error_code error;
  std::filesystem::create_directories(path, error);
  if (error) {
    refuse_writing(field, path, error.value());
  }
}

void require_directory_of(std::string_view field, const std::string& path) {
  const std::filesystem::path folder = std::filesystem::path(path).parent_path();
  std::error_code unknown;
  if (!folder.empty() && !std::filesystem::is_directory(folder, unknown)) {
    throw records::FileError({std::string(field), path},
                             fmt::format("there is no directory {}", folder.string()));
  }
}

int create_file(const std::string& path) {
  constexpr mode_t permissions = 0666;
  return ::open(path.c_str(), O_RDWR | O_CREAT | O_EXCL | O_CLOEXEC, permissions);
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

int write_and_close(int descriptor, std::string_view text) {
  const int error = write_all(descriptor, text);
  return ::close(descriptor) != 0 && error == 0 ? errno : error;
}

int synchronize_name(const std::string& path) {
  const std::string folder = std::filesystem::path(path).parent_path().string();
  const int descriptor = ::open(folder.empty() ? "." : folder.c_str(), O_RDONLY | O_CLOEXEC);
  if (descriptor < 0) {
    return errno == EACCES ? 0 : errno;  // one that can be written and not read
  }
  const int error = ::fsync(descriptor) != 0 ? errno : 0;
  ::close(descriptor);
  return error == EINVAL ? 0 : error;  // some file systems cannot, and need not
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
  constexpr int longest_chain = 40;  // as many as Linux follows
  std::error_code none;
  for (int i = 0; i < longest_chain && std::filesystem::is_symlink(path, none); ++i) {
    path = path.parent_path() / std::filesystem::read_symlink(path, none);
  }
  return path;
}

bool same_file(const std::string& a, const std::string& b) {
  std::error_code not_there;
  return std::filesystem::equivalent(a, b, not_there) || resolved_place(a) == resolved_place(b);
}

void require_apart(const std::vector<NamedFile>& inputs, const std::vector<NamedFile>& outputs) {
  for (std::size_t i = 0; i < outputs.size(); ++i) {
    const NamedFile& output = outputs[i];
    if (!may_be_a_file(output)) {
      continue;
    }
    for (const NamedFile& input : inputs) {
      if (is_one_file(input, output)) {
        throw records::FileError(
            {output.field, output.path},
            fmt::format("would overwrite the {}: give another file", shown(input)));
      }
    }
    for (std::size_t j = 0; j < i; ++j) {
      const NamedFile& other = outputs[j];
      const bool both_standard = is_standard_output(other.path) && is_standard_output(output.path);
      if (may_be_a_file(other) && !both_standard && is_one_file(other, output)) {
        throw records::FileError(
            {output.field, output.path},
            fmt::format("is also the file of {}: give two different files", shown(other)));
      }
    }
  }
}

}  // namespace stillpoint::sweep
