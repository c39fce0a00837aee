// SPDX-License-Identifier: MIT
#pragma once

#include "line_reader.hpp"

#include <string_view>

namespace stillpoint::sweep {

/// The fields of a line of CSV, one after the other. A field may be in double quotes, and then a
/// comma between them belongs to it (RFC 4180).
class CsvLine {
 public:
  /// `line` is the last one of `lines`.
  CsvLine(std::string_view line, const LineReader& lines) : rest_(line), lines_(lines) {}

  /// The next field without blanks and quotes; false after the last. Throws FileError if it opens a
  /// quote and does not close it.
  [[nodiscard]] bool next(std::string_view& field);

 private:
  std::string_view rest_;
  const LineReader& lines_;
  bool more_{true};
};

}  // namespace stillpoint::sweep
