// SPDX-License-Identifier: MIT
#include <stillpoint/records/record_list.hpp>

#include <stillpoint/core/input_error.hpp>
#include <stillpoint/records/file_error.hpp>
#include <stillpoint/records/number.hpp>
#include <stillpoint/records/text.hpp>

#include <algorithm>
#include <filesystem>
#include <system_error>

namespace stillpoint::records {

namespace {

constexpr std::size_t largest_list = std::size_t{1} << 20U;

/// A file beside the list, or else from where the program runs.
std::string beside(const std::string& list, const std::string& file) {
  std::filesystem::path place = std::filesystem::path(list).parent_path() / file;
  std::error_code unreachable;
  return std::filesystem::exists(place, unreachable) ? place.string() : file;
}

}  // namespace

std::vector<ListedRecord> read_record_list(const std::string& path) {
  const std::string text = read_text_file("records-list", path, largest_list);
  std::vector<ListedRecord> list;
  std::size_t number = 0;
  for (std::size_t begin = 0; begin < text.size();) {
    const std::size_t end = std::min(text.find('\n', begin), text.size());
    std::string line = text.substr(begin, end - begin);
    begin = end + 1;
    ++number;
    if (line.ends_with('\r')) {
      line.pop_back();
    }
    const FilePlace place{"records-list", path, number};
    if (number == 1) {
      if (line != "file,scale") {
        throw FileError(place, "must be the header file,scale");
      }
      continue;
    }
    if (line.empty() || line.starts_with('#')) {
      continue;
    }
    const std::size_t comma = line.rfind(',');
    if (comma == std::string::npos || comma == 0) {
      throw FileError(place, "must be FILE,SCALE");
    }
    try {
      const double scale = parse_number("scale", line.substr(comma + 1));
      if (scale == 0) {
        throw InputError("scale", 0, "must not be 0");
      }
      list.push_back({beside(path, line.substr(0, comma)), scale});
    } catch (const InputError& error) {
      throw FileError(place, error.what());
    }
  }
  if (list.empty()) {
    throw FileError({"records-list", path}, "has no record");
  }
  return list;
}

}  // namespace stillpoint::records
