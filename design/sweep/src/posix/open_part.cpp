// SPDX-License-Identifier: MIT
#include "part_file.hpp"

#include <stillpoint/records/file_error.hpp>
#include <stillpoint/records/text_file.hpp>
#include <stillpoint/sweep/output_file.hpp>

#include <fmt/format.h>

#include <fcntl.h>
#include <sys/file.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cerrno>
#include <cstddef>
#include <cstdio>
#include <exception>
#include <filesystem>
#include <system_error>
#include <utility>

namespace stillpoint::sweep {

namespace {

[[noreturn]] void refuse(const std::string& field, const std::string& path, std::string_view why) {
  throw records::FileError({.kind = field, .path = path}, why);
}

void lock(const OpenPart& files) {
  if (::flock(files.descriptor.number(), LOCK_EX | LOCK_NB) != 0) {
    refuse("output", files.part(),
           "another sweep is writing it: wait until it ends, or give another file");
  }
}

/// False if there is none. The lock of a running sweep is checked before anything else about its
/// file; it ends with that sweep, however that ends. FILE.part is never a link.
bool open_existing(OpenPart& files) {
  files.descriptor = Descriptor(::open(files.part().c_str(), O_RDWR | O_CLOEXEC | O_NOFOLLOW));
  if (files.descriptor.is_open()) {
    lock(files);
  } else if (errno != ENOENT) {
    refuse_writing("output", files.part(), errno);
  }
  return files.descriptor.is_open();
}

void create(OpenPart& files) {
  files.descriptor = Descriptor(create_file(files.part()));
  if (!files.descriptor.is_open()) {
    if (errno == EEXIST && open_existing(files)) {
      refuse("output", files.target,
             fmt::format("{} is left from an interrupted sweep: resume it with --resume, or "
                         "remove it to start again",
                         files.part()));
    }
    refuse_writing("output", files.target, errno);
  }
  lock(files);
  // Nothing is in the file before this is: an empty file without a checkpoint has just begun.
  try {
    files.save();
  } catch (...) {
    ::unlink(files.part().c_str());
    throw;
  }
}

/// Throws FileError unless the rows that are left belong to `label`.
void require_same(const OpenPart& files, const PartLabel& left, const PartLabel& label) {
  std::string differs = difference(left, label);
  if (differs.empty() && left.part != label.part) {
    differs = fmt::format("part was {}, is {}", text(left.part), text(label.part));
  }
  if (!differs.empty()) {
    refuse("resume", files.part(),
           fmt::format("was started with other options, {}: give the same ones, or remove the file "
                       "to start again",
                       differs));
  }
}

/// Cuts off what was written after the last checkpoint.
void cut_back(OpenPart& files, bool checkpoint_exists) {
  struct stat status {};
  if (::fstat(files.descriptor.number(), &status) != 0) {
    refuse_writing("output", files.part(), errno);
  }
  if (status.st_size > 0 && !checkpoint_exists) {
    refuse("resume", files.part(),
           fmt::format("{}, which says how far it got, is missing: remove the file to start again",
                       files.checkpoint()));
  }
  const std::int64_t bytes = files.saved.state.bytes;
  if (status.st_size < bytes) {
    refuse("resume", files.part(),
           fmt::format("has {} bytes, but {} says {}: remove the file to start again",
                       status.st_size, files.checkpoint(), bytes));
  }
  if (::ftruncate(files.descriptor.number(), bytes) != 0 ||
      ::lseek(files.descriptor.number(), 0, SEEK_END) != bytes) {
    refuse_writing("output", files.part(), errno);
  }
  if (!checkpoint_exists) {
    files.save();
  }
}

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

void OpenPart::save() const {
  if (const int error = replace(checkpoint(), text(saved) + "\n"); error != 0) {
    refuse_writing("output", checkpoint(), error);
  }
}

OpenPart open_part(PartLabel label, bool resume) {
  OpenPart files;
  files.target = behind_links(label.path).string();
  files.saved.label = std::move(label);
  if (!resume || !open_existing(files)) {
    create(files);
    return files;
  }
  const auto left = read_checkpoint(files.checkpoint());
  if (left) {
    require_same(files, left->label, files.saved.label);
    files.saved.state = left->state;
  }
  cut_back(files, left.has_value());
  return files;
}

}  // namespace stillpoint::sweep
