// SPDX-License-Identifier: MIT
#pragma once

#include <functional>
#include <optional>
#include <stdexcept>
#include <stop_token>
#include <string>
#include <thread>

namespace stillpoint::cli {

/// The user pressed Ctrl-C; nothing is written.
class Interrupted : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

/// Watches a long run: shows a line on standard error if that is a terminal, and lets an interrupt
/// end the run instead of the program. Only one may exist at a time.
class Progress {
 public:
  /// The line for what is done, after this many seconds. The time left is added to it.
  using Line = std::function<std::string(double done, double seconds)>;

  /// `end`: what is done at the end, 0 if that is not known; `begun_with`: what was done before.
  explicit Progress(Line line, double end = 0, double begun_with = 0);
  Progress(const Progress&) = delete;
  Progress& operator=(const Progress&) = delete;
  ~Progress();

  /// To be called now and then, with what is done: false after an interrupt.
  [[nodiscard]] bool goes_on(double done);
  /// If no terminal shows the line, says once, after the first second, that the run will take
  /// minutes.
  void announce_minutes(double done);
  [[nodiscard]] static bool interrupted();
  /// Stopped soon after an interrupt. A handler must not do that itself, so a thread looks for it.
  [[nodiscard]] std::stop_token stop_token();

 private:
  [[nodiscard]] double seconds_left(double done, double seconds) const;

  Line line_;
  double end_;
  double begun_with_;
  bool shown_;
  bool announced_{false};
  bool line_open_{false};
  double last_shown_s_{0};
  double started_s_;
  std::optional<double> last_done_;
  void (*previous_)(int);
  std::stop_source stop_;
  std::jthread watcher_;
};

}  // namespace stillpoint::cli
