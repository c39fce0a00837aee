// SPDX-License-Identifier: MIT
#pragma once

#include "descriptor.hpp"

#include <stillpoint/records/csv.hpp>

#include <cstddef>
#include <cstdint>
#include <optional>
#include <stop_token>
#include <string>
#include <string_view>
#include <vector>

namespace stillpoint::sweep {

/// The rows of a CSV file with a header, or of standard input, one at a time in constant memory.
/// Blank lines are skipped, a line has at most 64 KiB. Throws records::FileError, with the line.
class CsvFile {
 public:
  /// Reads the header. `path` "-" is standard input; `kind` says what the file is to the program,
  /// file_error.hpp, and `needed` what its header must have.
  CsvFile(const std::string& path, std::string kind, std::string_view needed);

  /// The names of the columns.
  [[nodiscard]] const std::vector<std::string>& names() const { return names_; }
  /// Whether there is another row, which has a cell for each name. False after a stop, even while
  /// it waits for input.
  [[nodiscard]] bool next(const std::stop_token& stop = {});
  /// A cell of the row, as it is.
  [[nodiscard]] const std::string& text(std::size_t column) const { return row_.fields()[column]; }

  /// The line that was read last, from 1.
  [[nodiscard]] std::int64_t line() const { return line_; }
  /// "standard input", or the path.
  [[nodiscard]] const std::string& source() const { return source_; }
  [[noreturn]] void refuse(std::optional<std::int64_t> line, std::string_view what) const;

 private:
  [[nodiscard]] bool next_row(const std::stop_token& stop);
  [[nodiscard]] bool next_line(std::string_view& line, const std::stop_token& stop);
  [[nodiscard]] bool next_of_all(std::string_view& line, const std::stop_token& stop);
  [[nodiscard]] bool read_more(const std::stop_token& stop);
  [[noreturn]] void refuse_unreadable(int error) const;

  std::string kind_;
  std::string source_;
  Descriptor descriptor_;
  std::vector<char> buffer_;
  std::size_t begin_{0};
  std::size_t end_{0};
  std::int64_t line_{0};
  bool ended_{false};
  records::CsvRow row_;
  std::vector<std::string> names_;
};

}  // namespace stillpoint::sweep
