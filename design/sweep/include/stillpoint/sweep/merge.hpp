// SPDX-License-Identifier: MIT
#pragma once

#include <stillpoint/sweep/checkpoint.hpp>
#include <stillpoint/sweep/output_file.hpp>

#include <cstdint>
#include <functional>
#include <stop_token>
#include <string>
#include <vector>

namespace stillpoint::sweep {

/// The result of a merge.
struct Merged {
  Checkpoint whole;
  std::int64_t bytes{0};
  bool stopped{false};  ///< then nothing is joined
};

struct MergeWatch {
  std::stop_token stop{};
  std::function<void(const Merged&)> progress{};  ///< called now and then
};

/// Throws FileError if what would be written is one of the parts.
void require_apart(const NamedFile& written, const std::vector<std::string>& parts);

/// Joins the parts of a sweep, in any order, into the file that the whole sweep would have written;
/// of parts that keep no rows the result is all, and nothing is written. Throws records::FileError
/// for a part that is incomplete, of another sweep or given twice, and for an output that cannot be
/// written; InputError for a part that is missing. The file is then not written.
Merged merge(const std::string& output, const std::vector<std::string>& parts,
             const MergeWatch& watch = {});

}  // namespace stillpoint::sweep
