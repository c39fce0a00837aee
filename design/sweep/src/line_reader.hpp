// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

namespace stillpoint::cli {

/// The lines of a file or of standard input, one at a time, in constant memory.
class LineReader {
 public:
  /// `path` "-" is standard input. Throws UsageError where it cannot be read.
  explicit LineReader(const std::string& path);
  LineReader(const LineReader&) = delete;
  LineReader& operator=(const LineReader&) = delete;
  LineReader(LineReader&& other) noexcept;
  LineReader& operator=(LineReader&&) = delete;
  ~LineReader();

  /// The next line without its end (LF or CR LF), good until the next call. False at the end and
  /// after an interrupt. Throws UsageError where it cannot be read or is longer than 64 KiB.
  [[nodiscard]] bool next(std::string_view& line);

  /// Of the line that was read last, from 1.
  [[nodiscard]] std::int64_t number() const { return number_; }
  /// "standard input", or the path.
  [[nodiscard]] const std::string& source() const { return source_; }

 private:
  bool read_more();

  std::string source_;
  int descriptor_;
  std::vector<char> buffer_;
  std::size_t begin_{0};
  std::size_t end_{0};
  std::int64_t number_{0};
  bool ended_{false};
};

}  // namespace stillpoint::cli
