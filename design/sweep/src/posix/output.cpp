// SPDX-License-Identifier: MIT
#include <stillpoint/sweep/output.hpp>
#include <stillpoint/sweep/output_file.hpp>

#include <fmt/format.h>

#include <fcntl.h>
#include <unistd.h>

#include <cerrno>
#include <cstdio>
#include <system_error>

namespace stillpoint::sweep {

Output::~Output() {
  for (const File& file : files_) {
    std::error_code ignored;
    if (!file.temporary.empty()) {
      std::filesystem::remove(file.temporary, ignored);
    }
  }
}

void Output::write_file(std::string_view field, const std::string& path, std::string_view text) {
  require_file_name(field, path);
  if (is_standard_output(path) || is_special_file(path)) {
    files_.push_back({std::string(field), path, std::string(text)});
    return;
  }
  // A link stays a link: its target is replaced.
  stage(field, behind_links(path), text);
}

void Output::stage(std::string_view field, const std::filesystem::path& target,
                   std::string_view text) {
  std::string temporary;
  int descriptor = -1;
  // The first name that is free, even from what a killed run left.
  for (int i = 0; descriptor < 0 && (i == 0 || errno == EEXIST); ++i) {
    temporary = fmt::format("{}.{}.new", target.string(), i);
    descriptor = create_file(temporary);
  }
  if (descriptor < 0) {
    refuse_writing(field, target.string(), errno);
  }
  files_.push_back({std::string(field), target.string(), "", temporary});
  if (const int error = write_and_close(descriptor, text); error != 0) {
    refuse_writing(field, target.string(), error);
  }
}

void Output::commit() {
  for (const auto& [field, target, text, temporary] : files_) {
    if (temporary.empty()) {
      const int descriptor = is_standard_output(target)
                                 ? ::dup(STDOUT_FILENO)
                                 : ::open(target.c_str(), O_WRONLY | O_CLOEXEC);
      const int error = descriptor < 0 ? errno : write_and_close(descriptor, text);
      if (error != 0) {
        refuse_writing(field, target, error);
      }
    }
  }
  if (std::fwrite(printed_.data(), 1, printed_.size(), stdout) != printed_.size() ||
      std::fflush(stdout) != 0) {
    if (errno != EBADF || !answers_in_file_) {
      refuse_writing("standard", "output", errno);
    }
  }
  for (File& file : files_) {
    std::error_code error;
    if (!file.temporary.empty()) {
      std::filesystem::rename(file.temporary, file.target, error);
    }
    if (error) {
      refuse_writing(file.field, file.target, error.value());
    }
    file.temporary.clear();
  }
}

}  // namespace stillpoint::sweep
