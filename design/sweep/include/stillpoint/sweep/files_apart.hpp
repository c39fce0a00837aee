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

/// The file that a sweep writes beside its output until it is complete.
[[nodiscard]] std::vector<NamedFile> part_files(const NamedFile& output);

/// Throws records::FileError if a file that would be written is also read, or would be written
/// twice. Links are followed; a device or a pipe may be written to any number of times.
void require_apart(const std::vector<NamedFile>& inputs, const std::vector<NamedFile>& outputs);

/// Throws records::FileError if the file belongs to a running sweep.
void require_not_swept(const NamedFile& output);

}  // namespace stillpoint::sweep
