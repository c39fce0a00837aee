// SPDX-License-Identifier: MIT
#pragma once

#include <optional>
#include <string>
#include <vector>

namespace stillpoint::records {

/// What a record is scaled to: a peak or a value of its spectrum, in g; with neither it keeps its
/// size.
struct RecordTarget {
  std::optional<double> peak{};
  std::optional<double> spectrum{};

  [[nodiscard]] bool is_given() const { return peak || spectrum; }
};

/// A line of a list of records.
struct ListedRecord {
  std::string path;  ///< beside the list if it is there, else from where the program runs
  double scale{1};   ///< not 0
  RecordTarget target{};
};

/// CSV with the header file,scale or file,peak or file,spectrum; blank lines and those that begin
/// with # are passed over. Throws FileError, with the line, for what is wrong.
[[nodiscard]] std::vector<ListedRecord> read_record_list(const std::string& path);

}  // namespace stillpoint::records
