// SPDX-License-Identifier: MIT
#include "row_sink.hpp"

#include "part_file.hpp"
#include "settings.hpp"
#include "sweep_task.hpp"
#include "writing.hpp"

#include <fmt/format.h>

#include <fcntl.h>
#include <unistd.h>

#include <cerrno>
#include <cstring>

namespace stillpoint::cli {

namespace {

/// Standard output, a device or a pipe: what is written is gone.
class StreamSink : public RowSink {
 public:
  StreamSink(int descriptor, std::string path, bool owned)
      : descriptor_(descriptor), path_(std::move(path)), owned_(owned) {}
  StreamSink(const StreamSink&) = delete;
  StreamSink& operator=(const StreamSink&) = delete;
  StreamSink(StreamSink&&) = delete;
  StreamSink& operator=(StreamSink&&) = delete;
  ~StreamSink() override {
    if (owned_) {
      ::close(descriptor_);
    }
  }

  [[nodiscard]] const SweepState& found() const override { return nothing_; }
  void write(std::string_view bytes) override {
    if (const int error = write_all(descriptor_, bytes); error != 0) {
      if (path_.empty()) {
        throw UsageError(
            fmt::format("standard output: cannot be written: {}", std::strerror(error)));
      }
      refuse_writing("output", path_, error);
    }
    wrote_ = true;
  }
  void reached(const SweepState& /*state*/) override {}
  void finish(const SweepState& /*state*/, std::string_view /*header*/) override {}
  [[nodiscard]] std::string leave() override {
    return wrote_ ? "the rows before it are written" : "nothing is written";
  }

 private:
  int descriptor_;
  std::string path_;
  bool owned_;
  bool wrote_{false};
  SweepState nothing_;
};

void require_streamable(const SweepTask& task, bool terminal) {
  if (task.resume) {
    throw UsageError("resume is for a file: give --output FILE as well");
  }
  if (task.format == RowFormat::npy && terminal) {
    throw UsageError("format npy is nothing for a terminal: give --output FILE");
  }
  if (task.format == RowFormat::npy && !task.source->total()) {
    throw UsageError(
        "format npy of a list needs a file, for its length stands at the beginning: give --output "
        "FILE");
  }
}

}  // namespace

bool goes_to_standard_output(const SweepTask& task) {
  return !task.output || is_standard_output(*task.output);
}

std::unique_ptr<RowSink> open_rows(const SweepTask& task) {
  if (task.output) {
    require_file_name("output", *task.output);
  }
  if (goes_to_standard_output(task)) {
    require_streamable(task, ::isatty(STDOUT_FILENO) == 1);
    return std::make_unique<StreamSink>(STDOUT_FILENO, "", false);
  }
  if (is_special_file(*task.output)) {
    require_streamable(task, false);
    const int descriptor = ::open(task.output->c_str(), O_WRONLY | O_CLOEXEC);
    if (descriptor < 0) {
      refuse_writing("output", *task.output, errno);
    }
    return std::make_unique<StreamSink>(descriptor, *task.output, true);
  }
  return std::make_unique<PartFile>(*task.output, task.identity, task.resume);
}

}  // namespace stillpoint::cli
