// SPDX-License-Identifier: MIT
#include <stillpoint/sweep/sink.hpp>

#include "part_file.hpp"

#include <stillpoint/core/input_error.hpp>
#include <stillpoint/records/file_error.hpp>
#include <stillpoint/sweep/output_file.hpp>
#include <stillpoint/sweep/spec.hpp>

#include <fmt/format.h>

#include <fcntl.h>
#include <unistd.h>

#include <cerrno>
#include <cstring>
#include <utility>

namespace stillpoint::sweep {

namespace {

/// Standard output, a device or a pipe: what is written is gone.
class StreamSink : public RowSink {
 public:
  StreamSink(Descriptor descriptor, std::string path)
      : descriptor_(std::move(descriptor)), path_(std::move(path)) {}

  [[nodiscard]] const SweepState& found() const override { return nothing_; }
  void write(std::string_view bytes) override {
    if (const int error = write_all(descriptor_.number(), bytes); error != 0) {
      refuse_writing(path_.empty() ? "standard" : "output", path_.empty() ? "output" : path_,
                     error);
    }
  }
  void reached(const SweepState& state) override { rows_ = state.rows; }
  void finish(const SweepState& /*state*/, std::string_view /*header*/) override {}
  LeftRows leave() override { return {rows_}; }

 private:
  Descriptor descriptor_;
  std::string path_;  ///< empty: standard output
  std::int64_t rows_{0};
  SweepState nothing_;
};

void require_streamable(const SweepSpec& spec, bool terminal) {
  if (spec.resume) {
    throw InputError("resume", "true", "needs an output file, which is then resumed");
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

bool goes_to_standard_output(const SweepSpec& spec) {
  return !spec.output || is_standard_output(*spec.output);
}

std::unique_ptr<RowSink> open_rows(const SweepSpec& spec) {
  require_valid(spec);  // before anything is created
  if (spec.output) {
    require_file_name("output", *spec.output);
  }
  if (goes_to_standard_output(spec)) {
    require_streamable(spec, ::isatty(STDOUT_FILENO) == 1);
    return std::make_unique<StreamSink>(Descriptor(STDOUT_FILENO), "");
  }
  if (is_special_file(*spec.output)) {
    require_streamable(spec, false);
    Descriptor descriptor(::open(spec.output->c_str(), O_WRONLY | O_CLOEXEC));
    if (!descriptor.is_open()) {
      refuse_writing("output", *spec.output, errno);
    }
    return std::make_unique<StreamSink>(std::move(descriptor), *spec.output);
  }
  return std::make_unique<PartFile>(spec.resume ? resume_part(*spec.output, spec.identity)
                                                : begin_part(*spec.output, spec.identity));
}

std::string description(const LeftRows& left) {
  if (left.count == 0) {
    return "nothing is written";
  }
  if (left.file.empty()) {
    return "the rows before it are written";
  }
  return fmt::format("{} kept in {}",
                     left.count == 1 ? "1 row is" : fmt::format("{} rows are", left.count),
                     left.file);
}

}  // namespace stillpoint::sweep
