// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <vector>

namespace stillpoint::records {

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

}  // namespace stillpoint::records
