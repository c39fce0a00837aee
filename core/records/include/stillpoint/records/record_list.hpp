// SPDX-License-Identifier: MIT
#pragma once

#include <stillpoint/records/record_scaling.hpp>

#include <string>
#include <vector>

namespace stillpoint::records {

/// A line of a list of records.
struct ListedRecord {
  std::string
      path;         ///< in the list's folder if it is there, else relative to the working directory
  double scale{1};  ///< not 0
  RecordTarget target{};
};

/// CSV with the header file,scale or file,peak or file,spectrum; blank lines and those that begin
/// with # are skipped. Throws FileError, with the line, for what is wrong.
[[nodiscard]] std::vector<ListedRecord> read_record_list(const std::string& path);

}  // namespace stillpoint::records
