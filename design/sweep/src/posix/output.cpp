// SPDX-License-Identifier: MIT
#include <stillpoint/sweep/output.hpp>
#include <stillpoint/sweep/output_file.hpp>

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cerrno>
#include <cstdio>
#include <cstdlib>
#include <system_error>

namespace stillpoint::sweep {

namespace {

/// The mode of a new file: mkstemp makes it readable only by its owner.
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

void Output::write_file(std::string_view field, const std::string& path, std::string_view text) {
  require_file_name(field, path);
  const bool standard = is_standard_output(path);
  if (standard || is_special_file(path)) {
    direct_.push_back({std::string(field), path, std::string(text), standard});
    return;
  }
  // A link stays a link: its target is replaced.
  stage(field, behind_links(path), text);
}

void Output::stage(std::string_view field, const std::filesystem::path& target,
                   std::string_view text) {
  std::string temporary = target.string() + ".XXXXXX";
  const int descriptor = ::mkstemp(temporary.data());
  if (descriptor < 0) {
    refuse_writing(field, target.string(), errno);
  }
  staged_.push_back({std::string(field), temporary, target});
  const bool permitted = ::fchmod(descriptor, permissions_for_new_files()) == 0;
  const int refused = permitted ? 0 : errno;
  const int error = write_and_close(descriptor, text);
  if (error != 0 || refused != 0) {
    refuse_writing(field, target.string(), error != 0 ? error : refused);
  }
}

void Output::commit() {
  for (const Direct& file : direct_) {
    if (file.is_standard_output) {
      if (const int error = write_all(STDOUT_FILENO, file.text); error != 0) {
        refuse_writing(file.field, file.target, error);
      }
      continue;
    }
    const int descriptor = ::open(file.target.c_str(), O_WRONLY | O_CLOEXEC);
    const int error = descriptor < 0 ? errno : write_and_close(descriptor, file.text);
    if (error != 0) {
      refuse_writing(file.field, file.target, error);
    }
  }
  if (std::fwrite(printed_.data(), 1, printed_.size(), stdout) != printed_.size() ||
      std::fflush(stdout) != 0) {
    refuse_writing("standard", "output", errno);
  }
  while (!staged_.empty()) {
    const Staged& file = staged_.back();
    std::error_code error;
    std::filesystem::rename(file.temporary, file.target, error);
    if (error) {
      refuse_writing(file.field, file.target.string(), error.value());
    }
    staged_.pop_back();
  }
}

}  // namespace stillpoint::sweep
