// SPDX-License-Identifier: MIT
#pragma once

#include <stillpoint/core/excitation.hpp>
#include <stillpoint/records/record_file.hpp>
#include <stillpoint/records/record_scaling.hpp>

#include <optional>
#include <string>
#include <vector>

namespace stillpoint::records {

/// W(tau) = scale * record.
struct SuiteRecord {
  std::string name;  ///< for messages and reports
  Record record;
  double scale{1};  ///< not 0
};

/// Where the records of a suite are.
struct SuiteFiles {
  std::vector<std::string> paths;     ///< files and folders
  std::optional<std::string> list{};  ///< more of them, see read_record_list
};

/// The records with their paths as names; those of a list have its factors as well, and its targets
/// where `scale` has none. Throws InputError and FileError.
[[nodiscard]] std::vector<SuiteRecord> read_suite(const SuiteFiles& files, const RecordScale& scale,
                                                  const RecordOptions& options);

/// The files in the folders of a suite that were skipped as plain text.
[[nodiscard]] std::vector<std::string> left_out_files(const SuiteFiles& files);

}  // namespace stillpoint::records
