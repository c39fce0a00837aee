// SPDX-License-Identifier: MIT
#include <stillpoint/records/record_suite.hpp>

#include <stillpoint/core/input_error.hpp>
#include <stillpoint/records/file_error.hpp>
#include <stillpoint/records/number.hpp>
#include <stillpoint/records/text.hpp>
#include <stillpoint/records/text_file.hpp>
#include <stillpoint/records/units.hpp>

#include <fmt/format.h>

#include <algorithm>
#include <string_view>
#include <utility>

namespace stillpoint::records {

namespace {

constexpr std::size_t largest_list = std::size_t{1} << 20U;

/// What the second column of a list contains.
enum class Column { scale, peak, spectrum };

/// The first and the last field of a line, without blanks and quotes; a name may have commas.
std::pair<std::string_view, std::string_view> name_and_value(std::string_view line) {
  const std::size_t comma = std::min(line.rfind(','), line.size());
  return {unquoted(line.substr(0, comma)), unquoted(line.substr(std::min(comma + 1, line.size())))};
}

Column header_column(const FilePlace& place, std::string_view line) {
  const auto [file, second] = name_and_value(line);
  for (const auto& [header, column] :
       {std::pair{"scale", Column::scale}, std::pair{"peak", Column::peak},
        std::pair{"spectrum", Column::spectrum}}) {
    if (file == "file" && second == header) {
      return column;
    }
  }
  throw FileError(place, "must be a header: file,scale or file,peak or file,spectrum");
}

/// Throws InputError.
ListedRecord listed_record(std::string path, Column column, std::string_view text) {
  if (column == Column::scale) {
    const double scale = parse_number("scale", text);
    if (scale == 0) {
      throw InputError("scale", 0, "must not be 0");
    }
    return {std::move(path), scale};
  }
  const char* const name = column == Column::peak ? "peak" : "spectrum";
  const double value = parse_value(name, Dimension::gravities, text);
  require_physical(name, Dimension::gravities, value);
  return {std::move(path), 1,
          column == Column::peak ? RecordTarget{value, {}} : RecordTarget{{}, value}};
}

}  // namespace

std::vector<ListedRecord> read_record_list(const std::string& path) {
  const std::string text = read_text_file("records-list", path, largest_list);
  std::vector<ListedRecord> list;
  Column column = Column::scale;
  std::size_t number = 0;
  const std::size_t mark = text.starts_with(byte_order_mark) ? byte_order_mark.size() : 0;
  for (std::string_view line : split(std::string_view(text).substr(mark), '\n')) {
    ++number;
    line = trimmed(line.substr(0, line.find_last_not_of('\r') + 1));
    const FilePlace place{"records-list", path, number};
    if (number == 1) {
      column = header_column(place, line);
      continue;
    }
    if (line.empty() || line.starts_with('#')) {
      continue;
    }
    const auto [file, value] = name_and_value(line);
    if (file.empty() || value.empty()) {
      throw FileError(place,
                      fmt::format("must be FILE,{}", column == Column::scale ? "SCALE" : "TARGET"));
    }
    try {
      list.push_back(listed_record(beside(path, std::string(file)), column, value));
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
