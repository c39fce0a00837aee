// SPDX-License-Identifier: MIT
#include "part_file.hpp"

#include <stillpoint/sweep/output_file.hpp>
#include <stillpoint/sweep/sink.hpp>

#include <fmt/format.h>

#include <fcntl.h>
#include <sys/file.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cerrno>
#include <filesystem>
#include <system_error>
#include <utility>

namespace stillpoint::sweep {

namespace {

void lock(const OpenPart& files) {
  if (::flock(files.descriptor.number(), LOCK_EX | LOCK_NB) != 0) {
    throw LeftoverError(fmt::format(
        "output {}: another sweep is writing it: wait until it ends, or give another file",
        files.part()));
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

void save(const OpenPart& files) {
  if (const int error = write_checkpoint(files.checkpoint(), files.saved); error != 0) {
    refuse_writing("output", files.checkpoint(), error);
  }
}

void create(OpenPart& files) {
  files.descriptor = Descriptor(create_file(files.part()));
  if (!files.descriptor.is_open()) {
    if (errno == EEXIST && open_existing(files)) {
      throw LeftoverError(fmt::format(
          "output {}: {} is left from an interrupted sweep: resume it with --resume, or "
          "remove it to start again",
          files.target, files.part()));
    }
    refuse_writing("output", files.target, errno);
  }
  lock(files);
  // Nothing is in the file before this is: an empty file without a checkpoint has just begun.
  try {
    save(files);
  } catch (...) {
    ::unlink(files.part().c_str());
    throw;
  }
}

/// Cuts off what was written after the last checkpoint.
void cut_back(OpenPart& files, bool checkpoint_exists) {
  struct stat status {};
  if (::fstat(files.descriptor.number(), &status) != 0) {
    refuse_writing("output", files.part(), errno);
  }
  if (status.st_size > 0 && !checkpoint_exists) {
    throw LeftoverError(fmt::format(
        "resume {}: {}, which says how far it got, is missing: remove the file to start again",
        files.part(), files.checkpoint()));
  }
  const std::int64_t bytes = files.saved.bytes;
  if (status.st_size < bytes) {
    throw LeftoverError(
        fmt::format("resume {}: has {} bytes, but {} says {}: remove the file to start again",
                    files.part(), status.st_size, files.checkpoint(), bytes));
  }
  if (::ftruncate(files.descriptor.number(), bytes) != 0 ||
      ::lseek(files.descriptor.number(), 0, SEEK_END) != bytes) {
    refuse_writing("output", files.part(), errno);
  }
  if (!checkpoint_exists) {
    save(files);
  }
}

OpenPart files_of(const std::string& path, std::string task) {
  require_task(task);
  OpenPart files;
  files.target = behind_links(path).string();
  files.saved.task = std::move(task);
  return files;
}

}  // namespace

OpenPart begin_part(const std::string& path, std::string task) {
  OpenPart files = files_of(path, std::move(task));
  create(files);
  return files;
}

OpenPart resume_part(const std::string& path, std::string task) {
  OpenPart files = files_of(path, std::move(task));
  const bool part_exists = open_existing(files);
  std::optional<Checkpoint> left = read_checkpoint(files.checkpoint());
  const std::string differs = left ? difference(left->task, files.saved.task) : "";
  if (!part_exists) {
    // Either nothing is left, or a sweep ended between the last two steps of PartFile::finish.
    std::error_code unknown;
    const bool only_to_tidy =
        left && left->complete && differs.empty() && std::filesystem::exists(files.target, unknown);
    if (!only_to_tidy) {
      create(files);
      return files;
    }
  } else if (!differs.empty()) {
    throw LeftoverError(
        fmt::format("resume {}: was started with other options, {}: give the same ones, or remove "
                    "the file to start "
                    "again",
                    files.part(), differs));
  }
  const bool checkpoint_exists = left.has_value();
  if (left) {
    files.saved = *std::move(left);
  }
  if (part_exists) {
    cut_back(files, checkpoint_exists);
  }
  return files;
}

}  // namespace stillpoint::sweep
