// SPDX-License-Identifier: MIT
#include <stillpoint/records/record_suite.hpp>

#include <stillpoint/core/input_error.hpp>
#include <stillpoint/records/csv.hpp>
#include <stillpoint/records/file_error.hpp>
#include <stillpoint/records/number.hpp>
#include <stillpoint/records/text.hpp>
#include <stillpoint/records/text_file.hpp>
#include <stillpoint/records/units.hpp>

#include <fmt/format.h>

#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <utility>

namespace stillpoint::records {

namespace {

constexpr std::size_t largest_list = std::size_t{1} << 20U;

/// What the second column of a list contains.
enum class Column { scale, peak, spectrum };

Column header_column(const FilePlace& place, std::span<const std::string> fields) {
  for (const auto& [header, column] :
       {std::pair{"scale", Column::scale}, std::pair{"peak", Column::peak},
        std::pair{"spectrum", Column::spectrum}}) {
    if (fields.size() == 2 && trimmed(fields[0]) == "file" && trimmed(fields[1]) == header) {
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
  const std::size_t mark = text.starts_with(byte_order_mark) ? byte_order_mark.size() : 0;
  std::vector<std::string_view> lines = split(std::string_view(text).substr(mark), '\n');
  FilePlace place{"records-list", path, 0};
  CsvRow row;
  std::size_t at = 0;
  const auto next = [&](std::string_view& line) {
    line = at < lines.size() ? lines[at].substr(0, lines[at].find_last_not_of('\r') + 1) : "";
    return at++ < lines.size();
  };
  std::optional<Column> column;
  std::vector<ListedRecord> list;
  for (std::string_view line; next(line);) {
    if (trimmed(line).empty() || trimmed(line).starts_with('#')) {
      continue;
    }
    place.line = at;
    if (const std::string_view fault = row.read(line, next); !fault.empty()) {
      throw FileError(place, fault);
    }
    if (!column) {
      column = header_column(place, row.fields());
      continue;
    }
    const auto fields = row.fields();
    if (fields.size() != 2 || fields[0].empty() || fields[1].empty()) {
      throw FileError(place,
                      fields.size() > 2
                          ? "must be FILE,NUMBER; a name with a comma must be in double quotes"
                          : "must be FILE,NUMBER");
    }
    try {
      list.push_back(listed_record(beside(path, fields[0]), *column, trimmed(fields[1])));
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
