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
  RecordUnits units{RecordUnits::g};
  bool assumed_g{false};  ///< neither the file nor the options give the units
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

/// The files of a folder by the ending of their names, each kind in the order of the names.
struct FolderFiles {
  std::vector<std::string> records;
  std::vector<std::string> plain_text;  ///< which ends like a record; see is_plain_text
};

/// Empty if `path` is not a folder.
[[nodiscard]] FolderFiles folder_files(const std::string& path);

/// The records of a folder: the files whose names have the ending of one, in the order of their
/// names, but for a .txt, .csv or .dat that is plain text. If `path` is not a folder, the path
/// itself. Throws FileError for a folder without any.
[[nodiscard]] std::vector<std::string> record_files(const std::string& path);

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

/// The files and folders of a suite, each with its scale and its target, `of_all` where it has none
/// itself. Throws FileError.
[[nodiscard]] std::vector<ListedRecord> asked_records(const SuiteFiles& files,
                                                      const RecordTarget& of_all);

/// A sentence for each file that a suite leaves out as plain text, and for what is doubtful in the
/// others: units, scale and peak, a vertical component, an offset, an end that is cut off, values
/// of a spectrum, times in ms and times that jump. The files are read again.
[[nodiscard]] std::vector<std::string> suite_doubts(const SuiteFiles& files,
                                                    const RecordScale& scale,
                                                    const RecordOptions& options);

}  // namespace stillpoint::records
