// SPDX-License-Identifier: MIT
#pragma once

#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

namespace stillpoint::sweep {

/// The output of one run. All of it appears, or none: files are written under another name and
/// moved into place by `commit` once standard output has been written. A target that is not a
/// regular file (a device, a pipe) is written to directly, before that.
class Output {
 public:
  Output() = default;
  Output(const Output&) = delete;
  Output& operator=(const Output&) = delete;
  ~Output();  ///< removes what was not committed

  void print(std::string_view text) { printed_ += text; }

  /// Standard output may be closed: a file has the answer.
  void answer_in_file() { answers_in_file_ = true; }

  /// Throws FileError, naming the field, if the file cannot be written. No two files may be the
  /// same.
  void write_file(std::string_view field, const std::string& path, std::string_view text);

  /// Throws FileError if anything cannot be written.
  void commit();

 private:
  struct File {
    std::string field;
    std::string target;
    std::string text;         ///< of what is no regular file
    std::string temporary{};  ///< else it is here until it is moved
  };

  void stage(std::string_view field, const std::filesystem::path& target, std::string_view text);

  std::string printed_;
  bool answers_in_file_{false};
  std::vector<File> files_;
};

}  // namespace stillpoint::sweep
