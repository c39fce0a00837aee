// SPDX-License-Identifier: MIT
#include "part_file.hpp"

#include <stillpoint/core/seconds.hpp>
#include <stillpoint/records/file_error.hpp>
#include <stillpoint/records/text_file.hpp>
#include <stillpoint/sweep/output_file.hpp>

#include <fmt/format.h>

#include <fcntl.h>
#include <sys/file.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <cstddef>
#include <cstdio>
#include <exception>
#include <filesystem>
#include <system_error>
#include <utility>

namespace stillpoint::sweep {

namespace {

constexpr double least_between_saves_s = 0.1;  // a save waits for the disk

[[noreturn]] void refuse(const std::string& field, const std::string& path, std::string_view why) {
  throw records::FileError({.kind = field, .path = path}, why);
}

void require_written(bool done, const std::string& path) {
  if (!done) {
    refuse_writing("output", path, errno);
  }
}

/// In one step: the old or the new content is there whenever the program ends. Returns 0 or the
/// errno.
int replace(const std::string& path, const std::string& content) {
  const std::string next = path + ".new";
  // Our own file, even if somebody has put a link under its name.
  ::unlink(next.c_str());
  const Descriptor file(create_file(next));
  if (!file.is_open()) {
    return errno;
  }
  int error = write_all(file.number(), content);
  // In this order, or after a power cut the name may lead to nothing.
  if (error == 0 && (::fsync(file.number()) != 0 || std::rename(next.c_str(), path.c_str()) != 0)) {
    error = errno;
  }
  if (error != 0) {
    ::unlink(next.c_str());
    return error;
  }
  return synchronize_name(path);
}

}  // namespace

std::optional<Checkpoint> read_checkpoint(const std::string& path) {
  constexpr std::size_t largest = std::size_t{1} << 26U;  // a task holds axes, which may be long
  std::error_code unknown;
  if (!std::filesystem::exists(path, unknown)) {
    return std::nullopt;
  }
  const std::string content = records::read_text_file("resume", path, largest);
  try {
    return parse_checkpoint(content);
  } catch (const std::exception&) {
    refuse("resume", path, "is not the checkpoint of a sweep: remove it to start again");
  }
}

PartFile::PartFile(Checkpoint sweep, bool resume)
    : target_(behind_links(sweep.path).string()),
      part_(target_ + ".part"),
      checkpoint_(part_ + ".json"),
      saved_(std::move(sweep)) {
  if (resume && open_existing()) {
    this->resume();
  } else {
    create();
  }
  next_save_s_ = seconds_now() + least_between_saves_s;
}

void PartFile::lock() const {
  if (::flock(descriptor_.number(), LOCK_EX | LOCK_NB) != 0) {
    refuse("output", part_,
           "another sweep is writing it: wait until it ends, or give another file");
  }
}

/// False if there is none. The lock of a running sweep is checked before anything else about its
/// file; it ends with that sweep, however that ends. FILE.part is never a link.
bool PartFile::open_existing() {
  descriptor_ = Descriptor(::open(part_.c_str(), O_RDWR | O_CLOEXEC | O_NOFOLLOW));
  if (descriptor_.is_open()) {
    lock();
  } else {
    require_written(errno == ENOENT, part_);
  }
  return descriptor_.is_open();
}

void PartFile::create() {
  descriptor_ = Descriptor(create_file(part_));
  if (!descriptor_.is_open()) {
    if (errno == EEXIST && open_existing()) {
      refuse("output", target_,
             fmt::format("{} is left from an interrupted sweep: resume it with --resume, or "
                         "remove it to start again",
                         part_));
    }
    refuse_writing("output", target_, errno);
  }
  lock();
  // Nothing is in the file before this is: an empty file without a checkpoint has just begun.
  try {
    save_checkpoint();
  } catch (...) {
    ::unlink(part_.c_str());
    throw;
  }
}

/// Throws FileError unless the rows that are left belong to the same sweep.
void PartFile::resume() {
  const auto left = read_checkpoint(checkpoint_);
  if (left) {
    std::string differs = difference(*left, saved_);
    if (differs.empty() && left->part != saved_.part) {
      differs = fmt::format("part was {}, is {}", text(left->part), text(saved_.part));
    }
    if (!differs.empty()) {
      refuse("resume", part_,
             fmt::format("was started with other options, {}: give the same ones, or remove the "
                         "file to start again",
                         differs));
    }
    state_ = saved_.state = left->state;
    set_found(state_);
  }
  cut_back(left.has_value());
}

/// Cuts off what was written after the last checkpoint.
void PartFile::cut_back(bool checkpoint_exists) {
  struct stat status {};
  require_written(::fstat(descriptor_.number(), &status) == 0, part_);
  if (status.st_size > 0 && !checkpoint_exists) {
    refuse("resume", part_,
           fmt::format("{}, which says how far it got, is missing: remove the file to start again",
                       checkpoint_));
  }
  const std::int64_t bytes = state_.bytes;
  if (status.st_size < bytes) {
    refuse("resume", part_,
           fmt::format("has {} bytes, but {} says {}: remove the file to start again",
                       status.st_size, checkpoint_, bytes));
  }
  require_written(::ftruncate(descriptor_.number(), bytes) == 0 &&
                      ::lseek(descriptor_.number(), 0, SEEK_END) == bytes,
                  part_);
  if (!checkpoint_exists) {
    save_checkpoint();
  }
}

void PartFile::save_checkpoint() const {
  if (const int error = replace(checkpoint_, text(saved_) + "\n"); error != 0) {
    refuse_writing("output", checkpoint_, error);
  }
}

void PartFile::write(std::string_view bytes) {
  if (const int error = write_all(descriptor_.number(), bytes); error != 0) {
    state_ = saved_.state;  // a full disk has no room for a later checkpoint either
    refuse_writing("output", part_, error);
  }
}

void PartFile::reached(const SweepState& state) {
  state_ = state;
  if (seconds_now() >= next_save_s_) {
    save();
  }
}

void PartFile::synchronize() const {
  require_written(::fdatasync(descriptor_.number()) == 0, part_);
}

void PartFile::save() {
  constexpr double pause = 20;  // times as long as a save takes, so they take 5 % at most
  const double begun = seconds_now();
  synchronize();
  saved_.state = state_;
  save_checkpoint();
  const double ended = seconds_now();
  next_save_s_ = ended + std::max(least_between_saves_s, pause * (ended - begun));
}

void PartFile::finish(std::string_view header) {
  require_written(::pwrite(descriptor_.number(), header.data(), header.size(), 0) ==
                      static_cast<ssize_t>(header.size()),
                  part_);
  synchronize();
  require_written(std::rename(part_.c_str(), target_.c_str()) == 0, target_);
  // Until then the checkpoint is needed.
  if (const int error = synchronize_name(target_); error != 0) {
    refuse_writing("output", target_, error);
  }
  std::error_code ignored;
  std::filesystem::remove(checkpoint_, ignored);
}

LeftRows PartFile::leave() {
  if (saved_.state.rows == 0 && state_.rows == 0) {
    std::error_code ignored;
    std::filesystem::remove(checkpoint_, ignored);
    std::filesystem::remove(part_, ignored);
    return {};
  }
  if (state_.rows > saved_.state.rows) {
    save();
  }
  return {saved_.state.rows, part_};
}

}  // namespace stillpoint::sweep
