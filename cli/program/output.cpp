// SPDX-License-Identifier: MIT
#include "output.hpp"

#include <sys/ioctl.h>
#include <unistd.h>

#include <algorithm>
#include <charconv>
#include <cstdlib>
#include <string_view>

namespace stillpoint::cli {

namespace {

bool coloured() {
  const char* no_color = std::getenv("NO_COLOR");
  const char* terminal = std::getenv("TERM");
  const bool refused = no_color != nullptr && *no_color != '\0';
  const bool dumb = terminal == nullptr || std::string_view(terminal) == "dumb";
  return !refused && !dumb && ::isatty(STDOUT_FILENO) == 1;
}

}  // namespace

std::string shown(const report::Document& document, const Settings& settings) {
  return text(document, {.title = settings.text("title").value_or(""),
                         .coloured = coloured(),
                         .verbosity = settings.flag("verbose") ? report::Verbosity::full
                                                               : report::Verbosity::normal});
}

std::size_t help_width() {
  constexpr std::size_t usual = 80;
  constexpr std::size_t least = 50;
  const char* const columns = std::getenv("COLUMNS");
  const std::string_view given = columns == nullptr ? "" : columns;
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

}  // namespace stillpoint::cli
