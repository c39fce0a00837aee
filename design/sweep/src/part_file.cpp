// SPDX-License-Identifier: MIT
#include "part_file.hpp"

#include "seconds.hpp"
#include "settings.hpp"
#include "writing.hpp"

#include <fmt/format.h>

#include <fcntl.h>
#include <sys/file.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <cstdio>
#include <filesystem>
#include <system_error>
#include <utility>

namespace stillpoint::cli {

namespace {

constexpr const char* field = "output";

bool exists(const std::string& path) {
  std::error_code unknown;
  return std::filesystem::exists(path, unknown);
}

std::string rows_are(std::int64_t rows) {
  return fmt::format("{} {}", rows, rows == 1 ? "row is" : "rows are");
}

}  // namespace

PartFile::PartFile(const std::string& path, std::string task, bool resume)
    : target_(behind_links(path).string()) {
  saved_.task = std::move(task);
  if (resume) {
    open_left();
  } else {
    open_new();
  }
}

PartFile::~PartFile() {
  if (descriptor_ >= 0) {
    ::close(descriptor_);
  }
}

void PartFile::refuse(int error) {
  refuse_writing(field, part(), error);
}

void PartFile::lock() {
  if (::flock(descriptor_, LOCK_EX | LOCK_NB) != 0) {
    throw UsageError(fmt::format(
        "{} {}: another sweep is writing it: let it end, or give another file", field, part()));
  }
}

/// False where there is none. The lock of a sweep that is alive comes before whatever else is to be
/// said of its file; it ends with that sweep, however that ends. The part is nobody's link.
bool PartFile::open_part() {
  descriptor_ = ::open(part().c_str(), O_RDWR | O_CLOEXEC | O_NOFOLLOW);
  if (descriptor_ < 0 && errno != ENOENT) {
    refuse(errno);
  }
  if (descriptor_ >= 0) {
    lock();
  }
  return descriptor_ >= 0;
}

void PartFile::open_new() {
  descriptor_ = ::open(part().c_str(), O_RDWR | O_CREAT | O_EXCL | O_CLOEXEC, 0666);
  if (descriptor_ < 0 && errno == EEXIST && open_part()) {
    throw UsageError(
        fmt::format("{} {}: {} is left of an interrupted sweep: go on with --resume, or remove it "
                    "to start anew",
                    field, target_, part()));
  }
  if (descriptor_ < 0) {
    refuse_writing(field, target_, errno);
  }
  lock();
  // Nothing stands in the file before this does: an empty file without it is one that just began.
  save();
}

void PartFile::open_left() {
  const bool part_is_there = open_part();
  std::optional<Checkpoint> left = read_checkpoint(checkpoint());
  const std::string differs = left ? difference(left->task, saved_.task) : "";
  if (!part_is_there) {
    // Either nothing is left, or the program ended between the last two steps of `finish`.
    const bool only_to_tidy = left && left->complete && differs.empty() && exists(target_);
    if (!only_to_tidy) {
      return open_new();
    }
  } else if (!differs.empty()) {
    throw UsageError(fmt::format(
        "resume {}: was begun with other options, {}: give the same, or remove the file to start "
        "anew",
        part(), differs));
  }
  const bool checkpoint_is_there = left.has_value();
  if (left) {
    saved_ = *std::move(left);
  }
  found_ = state_ = saved_.state;
  bytes_ = saved_.bytes;
  if (part_is_there) {
    cut_back(checkpoint_is_there);
  }
}

/// What is behind the last checkpoint is cut off.
void PartFile::cut_back(bool checkpoint_is_there) {
  struct stat status {};
  if (::fstat(descriptor_, &status) != 0) {
    refuse(errno);
  }
  if (status.st_size > 0 && !checkpoint_is_there) {
    throw UsageError(fmt::format(
        "resume {}: {}, which says how far it is, is missing: remove the file to start anew",
        part(), checkpoint()));
  }
  if (status.st_size < bytes_) {
    throw UsageError(
        fmt::format("resume {}: has {} bytes, {} says {}: remove the file to start anew", part(),
                    status.st_size, checkpoint(), bytes_));
  }
  if (::ftruncate(descriptor_, bytes_) != 0 || ::lseek(descriptor_, 0, SEEK_END) != bytes_) {
    refuse(errno);
  }
  if (!checkpoint_is_there) {
    save();
  }
}

void PartFile::write(std::string_view bytes) {
  if (const int error = write_all(descriptor_, bytes); error != 0) {
    state_ = saved_.state;  // on a full disk there is no place for a later checkpoint either
    throw UsageError(fmt::format("{} {}: cannot be written: {}; {}", field, part(),
                                 std::generic_category().message(error), leave()));
  }
  bytes_ += static_cast<std::int64_t>(bytes.size());
}

void PartFile::reached(const SweepState& state) {
  state_ = state;
  if (seconds_now() >= next_save_s_) {
    save();
  }
}

void PartFile::synchronize() {
  if (::fdatasync(descriptor_) != 0) {
    refuse(errno);
  }
}

void PartFile::save() {
  constexpr double least_between_s = 0.1;
  constexpr double pause = 20;  // times what it took: so at most 5 % go into this
  const double begun = seconds_now();
  if (bytes_ > saved_.bytes) {
    synchronize();
  }
  saved_.state = state_;
  saved_.bytes = bytes_;
  if (const int error = write_checkpoint(checkpoint(), saved_); error != 0) {
    refuse_writing(field, checkpoint(), error);
  }
  const double ended = seconds_now();
  next_save_s_ = ended + std::max(least_between_s, pause * (ended - begun));
}

void PartFile::finish(const SweepState& state, std::string_view header) {
  if (!saved_.complete) {
    state_ = state;
    if (::pwrite(descriptor_, header.data(), header.size(), 0) !=
        static_cast<ssize_t>(header.size())) {
      refuse(errno);
    }
    synchronize();
    saved_.complete = true;
    save();
  }
  if (exists(part()) && std::rename(part().c_str(), target_.c_str()) != 0) {
    refuse_writing(field, target_, errno);
  }
  std::error_code ignored;
  std::filesystem::remove(checkpoint(), ignored);
}

std::string PartFile::leave() {
  if (saved_.state.rows == 0 && state_.rows == 0) {
    std::error_code ignored;
    std::filesystem::remove(checkpoint(), ignored);
    std::filesystem::remove(part(), ignored);
    return "nothing is written";
  }
  if (state_.rows > saved_.state.rows) {
    save();
  }
  return fmt::format("{} kept in {}, go on with the same command and --resume",
                     rows_are(saved_.state.rows), part());
}

}  // namespace stillpoint::cli
