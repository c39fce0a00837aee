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

#include <algorithm>
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

/// The rows of a list but for blank lines and comments; each knows its first line.
class Rows {
 public:
  Rows(std::string_view text, const std::string& path)
      : rest_(text), place_{"records-list", path, 0} {}

  /// False at the end.
  bool next() {
    std::string_view line;
    do {
      if (!next_line(line)) {
        return false;
      }
    } while (trimmed(line).empty() || trimmed(line).starts_with('#'));
    place_.line = lines_;
    const auto next = [this](std::string_view& more) { return next_line(more); };
    if (const std::string_view fault = row_.read(line, next); !fault.empty()) {
      throw FileError(place_, fault);
    }
    return true;
  }

  [[nodiscard]] std::span<const std::string> fields() const { return row_.fields(); }
  [[nodiscard]] const FilePlace& place() const { return place_; }

 private:
  bool next_line(std::string_view& line) {
    if (rest_.empty()) {
      return false;
    }
    ++lines_;
    const std::size_t end = std::min(rest_.find('\n'), rest_.size());
    line = rest_.substr(0, end);
    line.remove_suffix(line.ends_with('\r') ? 1 : 0);
    rest_.remove_prefix(std::min(end + 1, rest_.size()));
    return true;
  }

  std::string_view rest_;
  FilePlace place_;
  std::size_t lines_{0};
  CsvRow row_;
};

}  // namespace

std::vector<ListedRecord> read_record_list(const std::string& path) {
  const std::string text = read_text_file("records-list", path, largest_list);
  const std::size_t mark = text.starts_with(byte_order_mark) ? byte_order_mark.size() : 0;
  Rows rows(std::string_view(text).substr(mark), path);
  std::vector<ListedRecord> list;
  const Column column = rows.next() ? header_column(rows.place(), rows.fields()) : Column::scale;
  while (rows.next()) {
    const auto fields = rows.fields();
    if (fields.size() != 2 || fields[0].empty() || fields[1].empty()) {
      throw FileError(
          rows.place(),
          fmt::format("must be FILE,{}{}", column == Column::scale ? "SCALE" : "TARGET",
                      fields.size() > 2 ? "; a name with a comma must be in double quotes" : ""));
    }
    try {
      list.push_back(listed_record(beside(path, fields[0]), column, trimmed(fields[1])));
    } catch (const InputError& error) {
      throw FileError(rows.place(), error.what());
    }
  }
  if (list.empty()) {
    throw FileError({"records-list", path}, "has no record");
  }
  return list;
}

}  // namespace stillpoint::records
