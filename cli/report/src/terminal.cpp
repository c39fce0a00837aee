// SPDX-License-Identifier: MIT
#include <stillpoint/report/terminal.hpp>

#include <sys/ioctl.h>
#include <unistd.h>

#include <algorithm>
#include <charconv>
#include <cstdlib>
#include <string_view>

namespace stillpoint::report {

namespace {

/// "" where it is not set.
std::string_view environment(const char* name) {
  const char* const value = std::getenv(name);
  return value == nullptr ? "" : value;
}

}  // namespace

std::size_t terminal_width() {
  constexpr std::size_t usual = 80;
  constexpr std::size_t least = 50;
  const std::string_view given = environment("COLUMNS");
  std::size_t width = 0;
  const auto [end, error] = std::from_chars(given.data(), given.data() + given.size(), width);
  if (error == std::errc() && end == given.data() + given.size() && width > 0) {
    return std::max(width, least);
  }
  ::winsize size{};
  const bool known = ::isatty(STDOUT_FILENO) == 1 &&
                     ::ioctl(STDOUT_FILENO, TIOCGWINSZ, &size) == 0 && size.ws_col > 0;
  return known ? std::max<std::size_t>(size.ws_col, least) : usual;
}

bool terminal_has_escapes() {
  return std::getenv("TERM") != nullptr && environment("TERM") != "dumb";
}

bool terminal_has_colours() {
  return environment("NO_COLOR").empty() && terminal_has_escapes() && ::isatty(STDOUT_FILENO) == 1;
}

}  // namespace stillpoint::report
