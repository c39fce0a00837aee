// SPDX-License-Identifier: MIT
#include "output.hpp"

#include "settings.hpp"

#include <fmt/format.h>

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cerrno>
#include <cstdio>
#include <cstring>
#include <system_error>

namespace stillpoint::cli {

namespace {

[[noreturn]] void refuse(const std::string& path, int error) {
  throw UsageError(fmt::format("output {}: cannot be written: {}", path, std::strerror(error)));
}

/// Writes everything and closes; 0 or the error.
int write_and_close(int descriptor, std::string_view text) {
  int error = 0;
  while (error == 0 && !text.empty()) {
    const ssize_t written = ::write(descriptor, text.data(), text.size());
    if (written >= 0) {
      text.remove_prefix(static_cast<std::size_t>(written));
    } else if (errno != EINTR) {
      error = errno;
    }
  }
  if (::close(descriptor) != 0 && error == 0) {
    error = errno;
  }
  return error;
}

/// What a new file would be allowed: mkstemp makes it readable by its owner alone.
mode_t permissions_for_new_files() {
  const mode_t mask = ::umask(0);
  ::umask(mask);
  return static_cast<mode_t>(0666) & ~mask;
}

}  // namespace

Output::~Output() {
  for (const Staged& file : staged_) {
    std::error_code ignored;
    std::filesystem::remove(file.temporary, ignored);
  }
}

void Output::write_file(const std::string& path, std::string_view text) {
  if (path.empty()) {
    throw UsageError("output \"\": must be the name of a file");
  }
  if (!paths_.insert(path).second) {
    throw UsageError(fmt::format("output {}: is wanted for two files at once", path));
  }
  std::error_code unknown;
  const auto status = std::filesystem::status(path, unknown);
  if (std::filesystem::is_directory(status)) {
    refuse(path, EISDIR);
  }
  if (std::filesystem::exists(status) && !std::filesystem::is_regular_file(status)) {
    direct_.push_back({path, std::string(text)});
    return;
  }
  // A link stays a link: what it points to is replaced.
  const std::filesystem::path target = std::filesystem::exists(status)
                                           ? std::filesystem::canonical(path, unknown)
                                           : std::filesystem::path(path);
  std::string temporary = target.string() + ".XXXXXX";
  const int descriptor = ::mkstemp(temporary.data());
  if (descriptor < 0) {
    refuse(path, errno);
  }
  staged_.push_back({temporary, target});
  const bool permitted = ::fchmod(descriptor, permissions_for_new_files()) == 0;
  const int refused = permitted ? 0 : errno;
  const int error = write_and_close(descriptor, text);
  if (error != 0 || refused != 0) {
    refuse(path, error != 0 ? error : refused);
  }
}

void Output::commit() {
  for (const Direct& file : direct_) {
    const int descriptor = ::open(file.target.c_str(), O_WRONLY | O_CLOEXEC);
    const int error = descriptor < 0 ? errno : write_and_close(descriptor, file.text);
    if (error != 0) {
      refuse(file.target, error);
    }
  }
  if (std::fwrite(printed_.data(), 1, printed_.size(), stdout) != printed_.size() ||
      std::fflush(stdout) != 0) {
    throw UsageError(fmt::format("standard output: cannot be written: {}", std::strerror(errno)));
  }
  while (!staged_.empty()) {
    std::error_code error;
    std::filesystem::rename(staged_.back().temporary, staged_.back().target, error);
    if (error) {
      refuse(staged_.back().target.string(), error.value());
    }
    staged_.pop_back();
  }
}

}  // namespace stillpoint::cli
