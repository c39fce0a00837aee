// SPDX-License-Identifier: MIT
#include <stillpoint/sweep/open_rows.hpp>

#include "part_file.hpp"

#include <stillpoint/core/input_error.hpp>
#include <stillpoint/records/file_error.hpp>
#include <stillpoint/sweep/output_file.hpp>

#include <fcntl.h>
#include <fmt/format.h>
#include <unistd.h>

#include <cerrno>
#include <utility>

namespace stillpoint::sweep {

namespace {

/// Standard output, a device or a pipe: what is written is gone.
class StreamSink : public RowSink {
 public:
  StreamSink(Descriptor descriptor, std::string path)
      : descriptor_(std::move(descriptor)), path_(std::move(path)) {}

  void write(std::string_view bytes) override {
    if (const int error = write_all(descriptor_.number(), bytes); error != 0) {
      refuse_writing(path_.empty() ? "standard" : "output", path_.empty() ? "output" : path_,
                     error);
    }
  }
  void reached(const SweepState& state) override { rows_ = state.rows; }
  LeftRows leave() override { return {rows_}; }

 private:
  Descriptor descriptor_;
  std::string path_;  ///< empty: standard output
  std::int64_t rows_{0};
};

/// What a complete part at the place of this one says; empty if there is none. Throws FileError for
/// another part of the same sweep.
std::optional<Checkpoint> find_part(const Checkpoint& wanted) {
  std::optional<Checkpoint> found;
  try {
    found = read_seal(wanted.path);
  } catch (const records::FileError&) {
    return std::nullopt;
  }
  if (!difference(*found, wanted).empty()) {
    return std::nullopt;
  }
  if (found->part != wanted.part) {
    throw records::FileError(
        {.kind = "output", .path = wanted.path},
        fmt::format("is part {} of this sweep: give each part its own file, for instance with "
                    "{{part}} in its name",
                    text(found->part)));
  }
  return found;
}

std::unique_ptr<RowSink> open_stream(const std::string& path) {
  Descriptor descriptor(::open(path.c_str(), O_WRONLY | O_CLOEXEC));
  if (!descriptor.is_open()) {
    refuse_writing("output", path, errno);
  }
  return std::make_unique<StreamSink>(std::move(descriptor), path);
}

void require_streamable(const SweepSpec& spec, bool terminal) {
  if (spec.resume) {
    throw InputError::missing("output", "resume continues the file of an interrupted sweep");
  }
  if (spec.format == RowFormat::npy && terminal) {
    throw InputError("format", "npy", "needs an output file: it cannot be shown on a terminal");
  }
  if (spec.format == RowFormat::npy && spec.list) {
    throw InputError("format", "npy",
                     "needs an output file for a list, whose length is part of the header");
  }
}

}  // namespace

bool keeps_rows(const SweepSpec& spec) {
  return !spec.reduction || (spec.part && spec.output);
}

bool goes_to_standard_output(const SweepSpec& spec) {
  return keeps_rows(spec) && (!spec.output || is_standard_output(*spec.output));
}

std::unique_ptr<RowSink> open_rows(const SweepSpec& spec) {
  require_valid(spec);  // before anything is created
  if (spec.output) {
    require_file_name("output", *spec.output);
  }
  if (!keeps_rows(spec)) {
    if (spec.resume) {
      throw InputError("resume", "true",
                       "cannot be combined with reduce: give --part and --output as well");
    }
    return std::make_unique<RowSink>();
  }
  if (goes_to_standard_output(spec)) {
    require_streamable(spec, ::isatty(STDOUT_FILENO) == 1);
    return std::make_unique<StreamSink>(Descriptor(STDOUT_FILENO), "");
  }
  if (is_special_file(*spec.output)) {
    require_streamable(spec, false);
    return open_stream(*spec.output);
  }
  Checkpoint begun = beginning(spec);
  if (spec.part) {
    if (const auto found = find_part(begun); found && spec.resume) {
      return std::make_unique<RowSink>(found->state);
    }
  }
  return std::make_unique<PartFile>(std::move(begun), spec.resume);
}

std::unique_ptr<RowSink> open_whole(const std::string& output, const std::string& task) {
  require_file_name("output", output);
  if (is_special_file(output)) {
    return open_stream(output);
  }
  return std::make_unique<PartFile>(Checkpoint{.path = output, .task = task}, true);
}

}  // namespace stillpoint::sweep
