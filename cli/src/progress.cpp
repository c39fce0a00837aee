// SPDX-License-Identifier: MIT
#include "progress.hpp"

#include <fmt/format.h>

#include <unistd.h>

#include <chrono>
#include <csignal>
#include <cstdio>

namespace stillpoint::cli {

namespace {

volatile std::sig_atomic_t interrupt_seen = 0;

void note_interrupt(int /*signal*/) {
  interrupt_seen = 1;
}

double seconds_now() {
  const auto now = std::chrono::steady_clock::now().time_since_epoch();
  return std::chrono::duration<double>(now).count();
}

}  // namespace

Progress::Progress(double end)
    : end_(end),
      shown_(::isatty(STDERR_FILENO) == 1),
      started_s_(seconds_now()),
      previous_(std::signal(SIGINT, note_interrupt)) {
  interrupt_seen = 0;
  if (previous_ == SIG_IGN) {
    std::signal(SIGINT, SIG_IGN);  // as in the background of a script
  }
}

Progress::~Progress() {
  std::signal(SIGINT, previous_);
  if (line_open_) {
    fmt::print(stderr, "\r\x1b[K");
  }
}

bool Progress::goes_on(double tau) {
  constexpr double quiet_s = 1;  // a run shorter than this needs no line
  constexpr double between_s = 0.2;
  const double now = seconds_now();
  if (shown_ && now - started_s_ > quiet_s && now - last_shown_s_ > between_s) {
    last_shown_s_ = now;
    line_open_ = true;
    fmt::print(stderr, "\rtau {:.6g}{}\x1b[K", tau,
               end_ > 0 ? fmt::format(" of {:.6g}, {:.0f} %", end_, 100 * tau / end_) : "");
    std::fflush(stderr);
  }
  return !interrupted();
}

bool Progress::interrupted() {
  return interrupt_seen != 0;
}

}  // namespace stillpoint::cli
