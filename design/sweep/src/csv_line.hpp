// SPDX-License-Identifier: MIT
#pragma once

#include <string_view>

namespace stillpoint::sweep {

/// The fields of a line of CSV, one after the other. A field may be in double quotes, and then a
/// comma between them belongs to it (RFC 4180).
class CsvLine {
 public:
  explicit CsvLine(std::string_view line) : rest_(line) {}

  /// The next field without blanks and quotes; false after the last.
  [[nodiscard]] bool next(std::string_view& field);
  /// The field that was read last opens a quote and does not close it.
  [[nodiscard]] bool unclosed() const { return unclosed_; }

 private:
  std::string_view rest_;
  bool more_{true};
  bool unclosed_{false};
};

}  // namespace stillpoint::sweep
