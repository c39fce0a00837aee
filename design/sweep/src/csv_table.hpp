// SPDX-License-Identifier: MIT
#pragma once

#include "line_reader.hpp"

#include <stillpoint/records/csv.hpp>

#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace stillpoint::sweep {

/// The rows of a CSV file with a header, one at a time. Throws records::FileError, with the line.
class CsvTable {
 public:
  /// Reads the header. `needed` says what it must have if the file is empty.
  CsvTable(const std::string& path, const std::string& kind, std::string_view needed);

  /// The names of the columns.
  [[nodiscard]] const std::vector<std::string>& names() const { return names_; }
  /// Whether there is another row; false after a stop as well. It has a cell for each name.
  [[nodiscard]] bool next(const std::stop_token& stop = {});
  /// A cell of the row, as it is.
  [[nodiscard]] const std::string& text(std::size_t column) const { return row_.fields()[column]; }

  [[nodiscard]] const LineReader& lines() const { return lines_; }
  /// Throws FileError about the row that was read last, or its header.
  [[noreturn]] void refuse(std::string_view what) const;

 private:
  [[nodiscard]] bool read(const std::stop_token& stop);

  LineReader lines_;
  records::CsvRow row_;
  std::vector<std::string> names_;
};

}  // namespace stillpoint::sweep
