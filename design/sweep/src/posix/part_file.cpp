// SPDX-License-Identifier: MIT
#include "part_file.hpp"

#include <stillpoint/core/seconds.hpp>
#include <stillpoint/sweep/output_file.hpp>

#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <cstdio>
#include <filesystem>
#include <system_error>
#include <utility>

namespace stillpoint::sweep {

namespace {

constexpr double least_between_saves_s = 0.1;  // a save waits for the disk

}  // namespace

PartFile::PartFile(OpenPart files)
    : RowSink(files.saved.state),
      files_(std::move(files)),
      state_(files_.saved.state),
      next_save_s_(seconds_now() + least_between_saves_s) {}

void PartFile::write(std::string_view bytes) {
  if (const int error = write_all(files_.descriptor.number(), bytes); error != 0) {
    state_ = files_.saved.state;  // a full disk has no room for a later checkpoint either
    refuse_writing("output", files_.part(), error);
  }
}

void PartFile::reached(const SweepState& state) {
  state_ = state;
  if (seconds_now() >= next_save_s_) {
    save();
  }
}

void PartFile::synchronize() {
  if (::fdatasync(files_.descriptor.number()) != 0) {
    refuse_writing("output", files_.part(), errno);
  }
}

void PartFile::save() {
  constexpr double pause = 20;  // times as long as a save takes, so they take 5 % at most
  const double begun = seconds_now();
  synchronize();
  files_.saved.state = state_;
  files_.save();
  const double ended = seconds_now();
  next_save_s_ = ended + std::max(least_between_saves_s, pause * (ended - begun));
}

void PartFile::finish(std::string_view header) {
  if (::pwrite(files_.descriptor.number(), header.data(), header.size(), 0) !=
      static_cast<ssize_t>(header.size())) {
    refuse_writing("output", files_.part(), errno);
  }
  synchronize();
  if (std::rename(files_.part().c_str(), files_.target.c_str()) != 0) {
    refuse_writing("output", files_.target, errno);
  }
  // Until then the checkpoint is needed.
  if (const int error = synchronize_name(files_.target); error != 0) {
    refuse_writing("output", files_.target, error);
  }
  std::error_code ignored;
  std::filesystem::remove(files_.checkpoint(), ignored);
}

LeftRows PartFile::leave() {
  if (files_.saved.state.rows == 0 && state_.rows == 0) {
    std::error_code ignored;
    std::filesystem::remove(files_.checkpoint(), ignored);
    std::filesystem::remove(files_.part(), ignored);
    return {};
  }
  if (state_.rows > files_.saved.state.rows) {
    save();
  }
  return {files_.saved.state.rows, files_.part()};
}

}  // namespace stillpoint::sweep
