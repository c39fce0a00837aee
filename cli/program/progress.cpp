// SPDX-License-Identifier: MIT
#include "progress.hpp"

#include "messages.hpp"

#include <stillpoint/core/seconds.hpp>
#include <stillpoint/report/terminal.hpp>

#include <fmt/format.h>

#include <unistd.h>

#include <algorithm>
#include <atomic>
#include <chrono>
#include <condition_variable>
#include <csignal>
#include <cstdio>
#include <mutex>
#include <utility>

namespace stillpoint::cli {

namespace {

std::atomic<bool> interrupt_seen{false};  // without a lock, as a handler needs it
static_assert(std::atomic<bool>::is_always_lock_free);

void note_interrupt(int /*signal*/) {
  interrupt_seen = true;
}

/// The previous handler of interrupts. An interrupt that comes after this one is installed is not
/// lost.
auto handle_interrupts() {
  interrupt_seen = false;
  return std::signal(SIGINT, note_interrupt);
}

}  // namespace

Progress::Progress(Line line, double end, double begun_with)
    : line_(std::move(line)),
      end_(end),
      begun_with_(begun_with),
      shown_(::isatty(STDERR_FILENO) == 1 && report::terminal_has_escapes() && !hushed()),
      announced_(hushed()),
      started_s_(seconds_now()),
      previous_(handle_interrupts()) {
  if (previous_ == SIG_IGN) {
    std::signal(SIGINT, SIG_IGN);  // as in the background of a script
  }
}

Progress::~Progress() {
  std::signal(SIGINT, previous_);
  if (line_open_) {
    write_error("\r\x1b[K");
  }
}

bool Progress::goes_on(double done) {
  constexpr double quiet_s = 1;  // a run shorter than this needs no line
  constexpr double between_s = 0.2;
  const double now = seconds_now();
  if (shown_ && now - started_s_ > quiet_s && now - last_shown_s_ > between_s) {
    last_shown_s_ = now;
    line_open_ = true;
    const double seconds = now - started_s_;
    write_error(fmt::format("\r{}{}\x1b[K", line_(done, seconds),
                            end_ > 0 ? report::time_left(seconds_left(done, seconds)) : ""));
  }
  return !interrupted();
}

double Progress::seconds_left(double done, double seconds) const {
  constexpr double most = 3.6e8;  // 100 thousand hours, which fit the line
  const double done_now = done - begun_with_;
  return done_now > 0 ? std::clamp(seconds * (end_ - done) / done_now, 0.0, most) : 0;
}

void Progress::announce_minutes(double done) {
  constexpr double known_after_s = 1;
  constexpr double long_s = 120;
  // At the first look a mass that was held at first is far already, which says nothing of the rest;
  // and there may be another pass over the same motion.
  if (!last_done_ || done < *last_done_) {
    started_s_ = seconds_now();
    begun_with_ = done;
  }
  last_done_ = done;
  const double seconds = seconds_now() - started_s_;
  if (shown_ || announced_ || seconds < known_after_s) {
    return;
  }
  announced_ = true;
  const double left_s = end_ > 0 ? seconds_left(done, seconds) : 0;
  if (left_s > long_s) {
    say(fmt::format("{}: about {:.0f} minutes to go", line_(done, seconds), left_s / 60));
  }
}

bool Progress::interrupted() {
  return interrupt_seen;
}

std::stop_token Progress::stop_token() {
  if (!watcher_.joinable()) {
    watcher_ = std::jthread([stop = stop_](const std::stop_token& ended) mutable {
      constexpr std::chrono::milliseconds between_looks{20};
      std::mutex mutex;
      std::condition_variable_any wake;
      std::unique_lock lock(mutex);
      while (!interrupted() && !ended.stop_requested()) {
        wake.wait_for(lock, ended, between_looks, [] { return interrupted(); });
      }
      if (interrupted()) {
        stop.request_stop();
      }
    });
  }
  return stop_.get_token();
}

}  // namespace stillpoint::cli
