// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <optional>
#include <stdexcept>
#include <string>
#include <string_view>

namespace stillpoint::records {

/// Where in a file something is wrong. Lines and columns count from 1.
struct FilePlace {
  std::string kind;  ///< what the program reads it as: "record", "list", "scene"
  std::string path;  ///< or the source of the text
  std::optional<std::size_t> line{};
  std::optional<std::size_t> column{};  ///< in bytes; only beside a line
};

/// A file that cannot be read or is wrong. The message begins with the place:
/// "record a.AT2, line 4: NPTS has no number".
class FileError : public std::runtime_error {
 public:
  FileError(FilePlace place, std::string_view message);

  /// "record a.AT2: cannot be read: No such file or directory", for an errno.
  [[nodiscard]] static FileError unreadable(FilePlace place, int error);

  [[nodiscard]] const FilePlace& place() const noexcept { return place_; }

 private:
  FilePlace place_;
};

}  // namespace stillpoint::records
