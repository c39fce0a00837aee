// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <vector>

namespace stillpoint::sweep {

/// A file as messages name it; `path` "-" is standard input or output.
struct NamedFile {
  std::string field;
  std::string path;
};

/// What a sweep writes beside its output until it is complete.
[[nodiscard]] std::vector<NamedFile> part_files(const NamedFile& output);

/// Throws records::FileError where a file that would be written is one that is read or is to be
/// written twice. Links are followed; a device or a pipe may be written to any number of times.
void require_apart(const std::vector<NamedFile>& inputs, const std::vector<NamedFile>& outputs);

/// Throws records::FileError where the file belongs to a sweep that is running.
void require_not_swept(const NamedFile& output);

}  // namespace stillpoint::sweep
