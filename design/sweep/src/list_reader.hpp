// SPDX-License-Identifier: MIT
#pragma once

#include "line_reader.hpp"
#include "sweep_quantity.hpp"

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace stillpoint::cli {

enum class ListFormat { csv, jsonl };

/// The entries of a list, one a line: CSV with a header that names the columns, or JSON objects
/// that all have the same keys. Blank lines are passed over. Columns are inputs of a sweep.
class ListReader {
 public:
  /// Without a format it is JSON lines where the first character that is no space is "{". Reads
  /// the header, or the first object. Throws UsageError with the number of the line.
  ListReader(const std::string& path, std::optional<ListFormat> format);

  [[nodiscard]] const std::vector<Quantity>& columns() const { return columns_; }

  /// The values of the next entry, one for each column; false at the end and after an interrupt.
  /// Throws UsageError with the number of the line.
  [[nodiscard]] bool next(std::vector<double>& values);

  /// Of the entry that was read last, from 1.
  [[nodiscard]] std::int64_t line() const { return lines_.number(); }
  [[nodiscard]] const std::string& source() const { return lines_.source(); }
  [[nodiscard]] ListFormat format() const { return format_; }

 private:
  /// The next line with something on it.
  bool next_line(std::string_view& line);
  void read_header(std::string_view line);
  void read_row(std::string_view line, std::vector<double>& values);
  void read_object(std::string_view line, std::vector<double>& values);
  [[noreturn]] void refuse(std::string_view what) const;

  LineReader lines_;
  ListFormat format_{ListFormat::csv};
  std::vector<Quantity> columns_;
  std::optional<std::vector<double>> first_;  ///< read with the keys, not yet asked for
};

}  // namespace stillpoint::cli
