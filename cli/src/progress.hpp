// SPDX-License-Identifier: MIT
#pragma once

#include <stdexcept>

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
  /// The run goes from 0 to `end`; 0 where that is not known.
  explicit Progress(double end);
  Progress(const Progress&) = delete;
  Progress& operator=(const Progress&) = delete;
  Progress(Progress&&) = delete;
  Progress& operator=(Progress&&) = delete;
  ~Progress();

  /// To be asked now and then, with the tau reached: false after an interrupt.
  [[nodiscard]] bool goes_on(double tau);
  [[nodiscard]] static bool interrupted();

 private:
  double end_;
  bool shown_;
  bool line_open_{false};
  double last_shown_s_{0};
  double started_s_;
  void (*previous_)(int);
};

}  // namespace stillpoint::cli
