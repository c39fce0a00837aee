// SPDX-License-Identifier: MIT
#include "line_reader.hpp"

#include "progress.hpp"
#include "settings.hpp"

#include <stillpoint/records/text.hpp>

#include <fmt/format.h>

#include <fcntl.h>
#include <poll.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <cstring>
#include <utility>

namespace stillpoint::cli {

namespace {

constexpr std::size_t longest_line = std::size_t{1} << 16U;
constexpr std::size_t buffer_size = 4 * longest_line;

/// Waits until there is something to read; false after an interrupt.
bool ready(int descriptor) {
  constexpr int between_looks_ms = 100;
  pollfd watched{descriptor, POLLIN, 0};
  while (!Progress::interrupted()) {
    if (::poll(&watched, 1, between_looks_ms) > 0) {
      return true;
    }
  }
  return false;
}

}  // namespace

LineReader::LineReader(const std::string& path)
    : source_(path == "-" ? "standard input" : path),
      descriptor_(path == "-" ? STDIN_FILENO : ::open(path.c_str(), O_RDONLY | O_CLOEXEC)),
      buffer_(buffer_size) {
  if (descriptor_ < 0) {
    throw UsageError(fmt::format("list {}: cannot be read: {}",
                                 records::shortened(source_, records::longest_path),
                                 std::strerror(errno)));
  }
}

LineReader::LineReader(LineReader&& other) noexcept
    : source_(std::move(other.source_)),
      descriptor_(std::exchange(other.descriptor_, -1)),
      buffer_(std::move(other.buffer_)),
      begin_(other.begin_),
      end_(other.end_),
      number_(other.number_),
      ended_(other.ended_) {}

LineReader::~LineReader() {
  if (descriptor_ > STDIN_FILENO) {
    ::close(descriptor_);
  }
}

/// False where there is nothing more.
bool LineReader::read_more() {
  if (begin_ > 0) {
    std::memmove(buffer_.data(), buffer_.data() + begin_, end_ - begin_);
    end_ -= begin_;
    begin_ = 0;
  }
  while (ready(descriptor_)) {
    const ssize_t count = ::read(descriptor_, buffer_.data() + end_, buffer_.size() - end_);
    if (count > 0) {
      end_ += static_cast<std::size_t>(count);
      return true;
    }
    if (count == 0) {
      return false;
    }
    if (errno != EINTR) {
      throw UsageError(fmt::format("list {}: cannot be read: {}", source_, std::strerror(errno)));
    }
  }
  return false;
}

bool LineReader::next(std::string_view& line) {
  std::size_t searched = 0;
  for (;;) {
    const char* const text = buffer_.data() + begin_;
    const std::size_t length = end_ - begin_;
    const void* const found = std::memchr(text + searched, '\n', length - searched);
    const bool whole = found != nullptr || (ended_ && length > 0);
    const auto size = found != nullptr
                          ? static_cast<std::size_t>(static_cast<const char*>(found) - text)
                          : length;
    if (size > longest_line) {
      throw UsageError(fmt::format("list {}: line {} is longer than {} bytes", source_, number_ + 1,
                                   longest_line));
    }
    if (whole) {
      ++number_;
      begin_ += std::min(size + 1, length);
      line = {text, size};
      if (line.ends_with('\r')) {
        line.remove_suffix(1);
      }
      return true;
    }
    if (ended_ || Progress::interrupted()) {
      return false;
    }
    searched = length;
    ended_ = !read_more() && !Progress::interrupted();
  }
}

}  // namespace stillpoint::cli
