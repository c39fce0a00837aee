// SPDX-License-Identifier: MIT
#include "../csv_file.hpp"

#include <stillpoint/records/file_error.hpp>
#include <stillpoint/records/text.hpp>
#include <stillpoint/records/text_file.hpp>

#include <fmt/format.h>

#include <fcntl.h>
#include <poll.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <cstring>
#include <utility>

namespace stillpoint::sweep {

namespace {

/// An entry has some hundred bytes; without a limit a binary file would be one line.
constexpr std::size_t longest_line = std::size_t{1} << 16U;
constexpr std::size_t buffer_size = 4 * longest_line;

/// Waits until there is something to read; false after a stop.
bool ready(int descriptor, const std::stop_token& stop) {
  constexpr int between_looks_ms = 100;  // a stop waits as long at most
  pollfd watched{descriptor, POLLIN, 0};
  while (!stop.stop_requested()) {
    if (::poll(&watched, 1, between_looks_ms) > 0) {
      return true;
    }
  }
  return false;
}

/// "1 value", "2 values"
std::string counted(std::size_t count, std::string_view what) {
  return fmt::format("{} {}{}", count, what, count == 1 ? "" : "s");
}

}  // namespace

CsvFile::CsvFile(const std::string& path, std::string kind, std::string_view needed)
    : kind_(std::move(kind)),
      source_(path == "-" ? "standard input" : path),
      descriptor_(path == "-" ? STDIN_FILENO : ::open(path.c_str(), O_RDONLY | O_CLOEXEC)),
      buffer_(buffer_size) {
  if (!descriptor_.is_open()) {
    refuse_unreadable(errno);
  }
  if (!next_row({})) {
    refuse({}, fmt::format("is empty: it must have a header{}", needed));
  }
  for (const std::string& name : row_.fields()) {
    names_.emplace_back(records::trimmed(name));
  }
}

bool CsvFile::next(const std::stop_token& stop) {
  if (!next_row(stop)) {
    return false;
  }
  if (row_.fields().size() != names_.size()) {
    refuse(line_,
           fmt::format("has {}, but the header names {}", counted(row_.fields().size(), "value"),
                       counted(names_.size(), "column")));
  }
  return true;
}

/// A quoted field may go on in further lines.
bool CsvFile::next_row(const std::stop_token& stop) {
  std::string_view text;
  if (!next_line(text, stop)) {
    return false;
  }
  const std::int64_t first = line_;
  const auto go_on = [this](std::string_view& more) { return next_line(more, {}); };
  if (const std::string_view fault = row_.read(text, go_on); !fault.empty()) {
    refuse(first, fault);
  }
  return true;
}

void CsvFile::refuse(std::optional<std::int64_t> line, std::string_view what) const {
  records::FilePlace place{.kind = kind_, .path = source_};
  if (line) {
    place.line = static_cast<std::size_t>(*line);
  }
  throw records::FileError(std::move(place), what);
}

void CsvFile::refuse_unreadable(int error) const {
  throw records::FileError::unreadable({.kind = kind_, .path = source_}, error);
}

/// False if there is nothing more.
bool CsvFile::read_more(const std::stop_token& stop) {
  if (begin_ > 0) {
    std::memmove(buffer_.data(), buffer_.data() + begin_, end_ - begin_);
    end_ -= begin_;
    begin_ = 0;
  }
  while (ready(descriptor_.number(), stop)) {
    const ssize_t count =
        ::read(descriptor_.number(), buffer_.data() + end_, buffer_.size() - end_);
    if (count > 0) {
      end_ += static_cast<std::size_t>(count);
      return true;
    }
    if (count == 0) {
      return false;
    }
    if (errno != EINTR) {
      refuse_unreadable(errno);
    }
  }
  return false;
}

/// Without its end, LF or CR LF, or a byte order mark; valid until the next call.
bool CsvFile::next_line(std::string_view& line, const std::stop_token& stop) {
  while (next_of_all(line, stop)) {
    if (line_ == 1 && line.starts_with(records::byte_order_mark)) {
      line.remove_prefix(records::byte_order_mark.size());
    }
    if (!records::trimmed(line).empty()) {
      return true;
    }
  }
  return false;
}

bool CsvFile::next_of_all(std::string_view& line, const std::stop_token& stop) {
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
      refuse(line_ + 1, fmt::format("is longer than {} bytes", longest_line));
    }
    if (whole) {
      ++line_;
      begin_ += std::min(size + 1, length);
      line = {text, size};
      if (line.ends_with('\r')) {
        line.remove_suffix(1);
      }
      return true;
    }
    if (ended_ || stop.stop_requested()) {
      return false;
    }
    searched = length;
    ended_ = !read_more(stop) && !stop.stop_requested();
  }
}

}  // namespace stillpoint::sweep
