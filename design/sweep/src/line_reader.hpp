// SPDX-License-Identifier: MIT
#pragma once

#include "descriptor.hpp"

#include <cstdint>
#include <optional>
#include <stop_token>
#include <string>
#include <string_view>
#include <vector>

namespace stillpoint::sweep {

/// The lines of a list, a file or standard input, that are not blank, one at a time, in constant
/// memory. Throws records::FileError.
class LineReader {
 public:
  /// `path` "-" is standard input; `kind` says what the file is to the program, file_error.hpp.
  LineReader(const std::string& path, std::string kind);

  /// The next line without its end (LF or CR LF) or a byte order mark, valid until the next call.
  /// False at the end and after a stop, even while it waits for input. A line has at most 64 KiB.
  [[nodiscard]] bool next(std::string_view& line, const std::stop_token& stop);

  /// The line that was read last, from 1.
  [[nodiscard]] std::int64_t number() const { return number_; }
  /// "standard input", or the path.
  [[nodiscard]] const std::string& source() const { return source_; }
  [[noreturn]] void refuse(std::optional<std::int64_t> line, std::string_view what) const;

 private:
  [[nodiscard]] bool next_of_all(std::string_view& line, const std::stop_token& stop);
  [[nodiscard]] bool read_more(const std::stop_token& stop);
  [[noreturn]] void refuse_unreadable(int error) const;

  std::string kind_;
  std::string source_;
  Descriptor descriptor_;
  std::vector<char> buffer_;
  std::size_t begin_{0};
  std::size_t end_{0};
  std::int64_t number_{0};
  bool ended_{false};
};

}  // namespace stillpoint::sweep
