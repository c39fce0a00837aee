// SPDX-License-Identifier: MIT
#include "progress.hpp"

#include "seconds.hpp"

#include <fmt/format.h>

#include <unistd.h>

#include <csignal>
#include <cstdio>
#include <utility>

namespace stillpoint::cli {

namespace {

volatile std::sig_atomic_t interrupt_seen = 0;

void note_interrupt(int /*signal*/) {
  interrupt_seen = 1;
}

/// What handled an interrupt before. One that comes once this one does is not forgotten.
auto handle_interrupts() {
  interrupt_seen = 0;
  return std::signal(SIGINT, note_interrupt);
}

}  // namespace

Progress::Progress(Line line, double end)
    : line_(std::move(line)),
      end_(end),
      shown_(::isatty(STDERR_FILENO) == 1),
      started_s_(seconds_now()),
      previous_(handle_interrupts()) {
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

bool Progress::goes_on(double done) {
  constexpr double quiet_s = 1;  // a run shorter than this needs no line
  constexpr double between_s = 0.2;
  const double now = seconds_now();
  if (shown_ && now - started_s_ > quiet_s && now - last_shown_s_ > between_s) {
    last_shown_s_ = now;
    line_open_ = true;
    fmt::print(stderr, "\r{}\x1b[K", line_(done, now - started_s_));
    std::fflush(stderr);
  }
  return !interrupted();
}

void Progress::announce_minutes(double done) {
  constexpr double known_after_s = 1;
  constexpr double long_s = 120;
  if (done < last_done_) {  // another pass over the same motion
    started_s_ = seconds_now();
  }
  last_done_ = done;
  const double seconds = seconds_now() - started_s_;
  if (shown_ || announced_ || seconds < known_after_s) {
    return;
  }
  announced_ = true;
  const double left_s = done > 0 ? seconds * (end_ - done) / done : 0;
  if (left_s > long_s) {
    fmt::print(stderr, "stillpoint: {}: some {:.0f} minutes to go\n", line_(done, seconds),
               left_s / 60);
  }
}

bool Progress::interrupted() {
  return interrupt_seen != 0;
}

Progress::Line progress_in_tau(double end) {
  return [end](double tau, double /*seconds*/) {
    return end > 0 ? fmt::format("tau {:.6g} of {:.6g}, {:.0f} %", tau, end, 100 * tau / end)
                   : fmt::format("tau {:.6g}", tau);
  };
}

}  // namespace stillpoint::cli
