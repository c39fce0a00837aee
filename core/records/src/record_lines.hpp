// SPDX-License-Identifier: MIT
#pragma once

#include <stillpoint/records/text.hpp>

#include <cstddef>
#include <string>
#include <string_view>

namespace stillpoint::records {

/// The lines of a record file, one after the other, and where its faults are reported. Lines end
/// with LF or CR LF; a byte order mark at the beginning is left out. A copy reads ahead.
class RecordLines {
 public:
  /// Both must outlive this. Throws FileError where the text is empty or binary.
  RecordLines(const std::string& path, const std::string& text);

  /// Goes to the next line; false, and stays, where there is none.
  bool next();

  [[nodiscard]] std::string_view line() const { return line_; }
  /// Counted from 1; 0 before the first `next`.
  [[nodiscard]] std::size_t number() const { return number_; }
  [[nodiscard]] const std::string& path() const { return *path_; }
  /// Bytes from here to the end.
  [[nodiscard]] std::size_t bytes_left() const { return rest_.size(); }

  /// Throws FileError "record PATH, line NUMBER: MESSAGE".
  [[noreturn]] void refuse(std::string_view message) const { refuse(number_, message); }
  [[noreturn]] void refuse(std::size_t number, std::string_view message) const;

  /// The number that `text`, a part of this line, stands for; refuses where it is none.
  [[nodiscard]] double parse_number(std::string_view text) const;

 private:
  const std::string* path_;
  std::string_view rest_;
  std::string_view line_;
  std::size_t number_{0};
};

}  // namespace stillpoint::records
