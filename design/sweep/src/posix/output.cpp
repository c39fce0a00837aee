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
  staged_.push_back({std::string(field), temporary, target});
  if (const int error = write_and_close(descriptor, text); error != 0) {
    refuse_writing(field, target.string(), error);
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
