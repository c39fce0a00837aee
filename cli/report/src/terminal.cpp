// SPDX-License-Identifier: MIT
#include <stillpoint/report/terminal.hpp>

#include <stillpoint/records/number.hpp>

#include <fmt/format.h>

#include <sys/ioctl.h>
#include <unistd.h>

#include <algorithm>
#include <cstdint>
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
  const std::int64_t given = records::scan_integer(environment("COLUMNS")).value_or(0);
  if (given > 0) {
    return std::max(static_cast<std::size_t>(given), least);
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

std::string progress_in_tau(double tau, double end) {
  return end > 0 ? fmt::format("tau {:.6g} of {:.6g}, {:.0f} %", tau, end, 100 * tau / end)
                 : fmt::format("tau {:.6g}", tau);
}

std::string time_left(double seconds) {
  const auto minutes = static_cast<std::int64_t>(seconds / 60);
  return fmt::format(", {}:{:02.0f} left", minutes, seconds - 60 * static_cast<double>(minutes));
}

}  // namespace stillpoint::report
