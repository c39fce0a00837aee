// SPDX-License-Identifier: MIT
#include <stillpoint/sweep/output_file.hpp>

#include <stillpoint/records/file_error.hpp>

#include <fmt/format.h>

namespace stillpoint::sweep {

namespace {

/// Invalid names are refused where the file is written.
bool may_be_a_file(const NamedFile& output) {
  return !output.path.empty() && output.path != "-" && !is_special_file(output.path);
}

bool is_one_file(const NamedFile& a, const NamedFile& b) {
  return same_file(a.path == "-" ? "/dev/stdin" : a.path, b.path);
}

std::string shown(const NamedFile& file) {
  return fmt::format("{} {}", file.field, file.path == "-" ? "on standard input" : file.path);
}

}  // namespace

void require_apart(const std::vector<NamedFile>& inputs, const std::vector<NamedFile>& outputs) {
  for (std::size_t i = 0; i < outputs.size(); ++i) {
    const NamedFile& output = outputs[i];
    if (!may_be_a_file(output)) {
      continue;
    }
    for (const NamedFile& input : inputs) {
      if (is_one_file(input, output)) {
        throw records::FileError(
            {output.field, output.path},
            fmt::format("would overwrite the {}: give another file", shown(input)));
      }
    }
    for (std::size_t j = 0; j < i; ++j) {
      const NamedFile& other = outputs[j];
      const bool both_standard = is_standard_output(other.path) && is_standard_output(output.path);
      if (may_be_a_file(other) && !both_standard && is_one_file(other, output)) {
        throw records::FileError(
            {output.field, output.path},
            fmt::format("is also the file of {}: give two different files", shown(other)));
      }
    }
  }
}

}  // namespace stillpoint::sweep
