// SPDX-License-Identifier: MIT
#include <stillpoint/records/file_error.hpp>
#include <stillpoint/records/record_suite.hpp>
#include <stillpoint/records/text.hpp>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <array>
#include <filesystem>
#include <system_error>

namespace stillpoint::records {

namespace {

/// In upper case. K-NET's .UD, the vertical component, is left out: the mass moves sideways.
constexpr std::array<std::string_view, 14> record_endings{".AT2", ".ASC", ".EW",  ".NS", ".EW1",
                                                          ".NS1", ".EW2", ".NS2", ".V2", ".V2C",
                                                          ".SMC", ".TXT", ".CSV", ".DAT"};

bool may_be_record(const std::filesystem::directory_entry& entry) {
  std::error_code unreachable;
  const std::filesystem::path name = entry.path().filename();
  return entry.is_regular_file(unreachable) && !name.string().starts_with('.') &&
         std::ranges::find(record_endings, upper_case(name.extension().string())) !=
             record_endings.end();
}

}  // namespace

std::vector<std::string> record_files(const std::string& path) {
  std::error_code error;
  if (!std::filesystem::is_directory(path, error)) {
    return {path};
  }
  std::vector<std::string> files;
  std::filesystem::directory_iterator entry(path, error);
  for (; !error && entry != std::filesystem::directory_iterator(); entry.increment(error)) {
    if (may_be_record(*entry)) {
      files.push_back(entry->path().string());
    }
  }
  if (error) {
    throw FileError::unreadable({"record", path}, error.value());
  }
  if (files.empty()) {
    throw FileError({"record", path}, fmt::format("this folder has no record: no name ends in {}",
                                                  fmt::join(record_endings, " ")));
  }
  std::ranges::sort(files);
  return files;
}

}  // namespace stillpoint::records
