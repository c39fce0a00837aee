// SPDX-License-Identifier: MIT
#pragma once

#include <functional>
#include <stdexcept>
#include <string>

namespace stillpoint::cli {

/// The user pressed Ctrl-C; nothing is written.
class Interrupted : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

/// Watches over a long run: a line on standard error when that is a terminal, and an interrupt that
/// ends the run instead of the program. One at a time.
class Progress {
 public:
  /// The line for what is done, after so many seconds.
  using Line = std::function<std::string(double done, double seconds)>;

  /// `end`: what is done when all is, where that is known.
  explicit Progress(Line line, double end = 0);
  Progress(const Progress&) = delete;
  Progress& operator=(const Progress&) = delete;
  Progress(Progress&&) = delete;
  Progress& operator=(Progress&&) = delete;
  ~Progress();

  /// To be asked now and then, with what is done: false after an interrupt.
  [[nodiscard]] bool goes_on(double done);
  /// Where no terminal shows the line, says once that the run will take minutes, if it will.
  void announce_minutes(double done);
  [[nodiscard]] static bool interrupted();

 private:
  Line line_;
  double end_;
  bool shown_;
  bool announced_{false};
  bool line_open_{false};
  double last_shown_s_{0};
  double started_s_;
  double last_done_{0};
  void (*previous_)(int);
};

/// "tau 3 of 10, 30 %"; `end` 0 where that is not known.
[[nodiscard]] Progress::Line progress_in_tau(double end);

}  // namespace stillpoint::cli
