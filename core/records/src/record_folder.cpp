// SPDX-License-Identifier: MIT
#include <stillpoint/records/record_suite.hpp>

#include "record_reader.hpp"

#include <stillpoint/records/file_error.hpp>
#include <stillpoint/records/record_file.hpp>
#include <stillpoint/records/text.hpp>
#include <stillpoint/records/text_file.hpp>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <filesystem>
#include <system_error>
#include <utility>
#include <vector>

namespace stillpoint::records {

namespace {

/// By the ending of the name; null if no format has it.
const RecordFormat* format_by_ending(const std::string& path) {
  const std::string ending = upper_case(std::filesystem::path(path).extension().string());
  for (const RecordFormat* each : record_formats()) {
    if (std::ranges::count(words_of(each->endings, " "), ending) > 0) {
      return each;
    }
  }
  return nullptr;
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
    if (const RecordFormat* const format = format_by_ending(file)) {
      // Notes, and the tables that databases put beside their records, end like columns.
      const bool is_text =
          format == &columns_format &&
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
    std::vector<std::string_view> endings(record_formats().size());
    std::ranges::transform(record_formats(), endings.begin(),
                           [](const RecordFormat* each) { return each->endings; });
    throw FileError({"record", path},
                    found.plain_text.empty()
                        ? fmt::format("this folder has no record: no file name ends in {}",
                                      fmt::join(endings, " "))
                        : fmt::format("this folder has no record: {} begins with text",
                                      shortened(found.plain_text.front(), longest_path)));
  }
  return std::move(found.records);
}

}  // namespace stillpoint::records
