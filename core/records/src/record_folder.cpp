// SPDX-License-Identifier: MIT
#include <stillpoint/records/record_suite.hpp>

#include <stillpoint/records/file_error.hpp>
#include <stillpoint/records/record_file.hpp>
#include <stillpoint/records/text.hpp>
#include <stillpoint/records/text_file.hpp>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <filesystem>
#include <system_error>
#include <utility>

namespace stillpoint::records {

namespace {

// In upper case. K-NET's .UD, the vertical component, is left out: the mass moves sideways.
constexpr auto record_endings = std::to_array<std::string_view>(
    {".AT2", ".ASC", ".EW", ".NS", ".EW1", ".NS1", ".EW2", ".NS2", ".V2", ".V2C", ".SMC"});
/// The endings of columns, but also of notes and of the tables that databases put beside their
/// records.
constexpr auto text_endings = std::to_array<std::string_view>({".TXT", ".CSV", ".DAT"});

template <std::size_t Count>
bool has_one_of(const std::array<std::string_view, Count>& endings, const std::string& path) {
  const std::string ending = upper_case(std::filesystem::path(path).extension().string());
  return std::ranges::find(endings, ending) != endings.end();
}

bool is_visible_file(const std::filesystem::directory_entry& entry) {
  std::error_code unreachable;
  return entry.is_regular_file(unreachable) && !entry.path().filename().string().starts_with('.');
}

std::vector<std::string> files_in(const std::string& folder) {
  std::vector<std::string> files;
  std::error_code error;
  std::filesystem::directory_iterator entry(folder, error);
  for (; !error && entry != std::filesystem::directory_iterator(); entry.increment(error)) {
    if (is_visible_file(*entry)) {
      files.push_back(entry->path().string());
    }
  }
  if (error) {
    throw FileError::unreadable({"record", folder}, error.value());
  }
  std::ranges::sort(files);
  return files;
}

bool is_folder(const std::string& path) {
  std::error_code error;
  return std::filesystem::is_directory(path, error);
}

}  // namespace

FolderFiles folder_files(const std::string& path) {
  FolderFiles found;
  for (std::string& file : is_folder(path) ? files_in(path) : std::vector<std::string>()) {
    if (has_one_of(record_endings, file)) {
      found.records.push_back(std::move(file));
    } else if (has_one_of(text_endings, file)) {
      const bool is_text =
          is_plain_text(read_text_file("record", file, largest_record_bytes), file);
      (is_text ? found.plain_text : found.records).push_back(std::move(file));
    }
  }
  return found;
}

std::vector<std::string> record_files(const std::string& path) {
  if (!is_folder(path)) {
    return {path};
  }
  FolderFiles found = folder_files(path);
  if (found.records.empty()) {
    throw FileError({"record", path},
                    found.plain_text.empty()
                        ? fmt::format("this folder has no record: no file name ends in {} {}",
                                      fmt::join(record_endings, " "), fmt::join(text_endings, " "))
                        : fmt::format("this folder has no record: {} begins with text",
                                      shortened(found.plain_text.front(), longest_path)));
  }
  return std::move(found.records);
}

}  // namespace stillpoint::records
