// SPDX-License-Identifier: MIT
#include "sweep.hpp"

#include "entry_threads.hpp"
#include "pictures.hpp"
#include "progress.hpp"
#include "row_sink.hpp"
#include "seconds.hpp"
#include "sweep_map.hpp"
#include "sweep_report.hpp"
#include "sweep_rows.hpp"
#include "sweep_run.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <optional>

namespace stillpoint::cli {

namespace {

using Eigen::Index;

/// So many entries at once that a block takes some tenths of a second at most: then an interrupt is
/// answered at once, however long an entry takes.
class BlockSize {
 public:
  [[nodiscard]] Index value() const { return value_; }

  void learn(double seconds) {
    constexpr double short_s = 0.05;
    constexpr double long_s = 0.3;
    constexpr Index least = 16;
    constexpr Index most = 65'536;
    if (seconds < short_s) {
      value_ = std::min(2 * value_, most);
    } else if (seconds > long_s) {
      value_ = std::max(value_ / 2, least);
    }
  }

 private:
  Index value_{256};
};

/// "4.2e+06 of 1e+08 rows, 4 %, 1.9e+06 rows/s, 0:50 left"
Progress::Line progress_in_rows(std::int64_t begun_with, std::optional<std::int64_t> total) {
  return [begun_with, total](double rows, double seconds) {
    const double rate = (rows - static_cast<double>(begun_with)) / seconds;
    if (!total) {
      return fmt::format("{:.4g} rows, {:.3g} rows/s", rows, rate);
    }
    const auto all = static_cast<double>(*total);
    const double left_s = rate > 0 ? std::min((all - rows) / rate, 3.6e8) : 0;
    const auto minutes = static_cast<std::int64_t>(left_s / 60);
    return fmt::format("{:.4g} of {:.4g} rows, {:.0f} %, {:.3g} rows/s, {}:{:02.0f} left", rows,
                       all, 100 * rows / all, rate, minutes,
                       left_s - 60 * static_cast<double>(minutes));
  };
}

/// One sweep, from where its sink stands to the end.
class Sweep {
 public:
  /// `map`, where there is one, is filled on the way.
  Sweep(const SweepTask& task, RowSink& sink, SweepMap* map)
      : task_(task),
        sink_(sink),
        map_(map),
        progress_(progress_in_rows(sink.found().rows, task.source->total())),
        run_(task),
        rows_(task),
        state_(sink.found()) {}

  SweepState operator()() {
    try {
      go_on();
    } catch (const EntryError& error) {
      const std::string place = task_.source->place(block_, error.entry());
      keep_before(error.entry());
      leave_refused(place.empty() ? error.what() : fmt::format("{}: {}", place, error.what()));
    }
    if (Progress::interrupted()) {
      throw Interrupted("interrupted: " + sink_.leave());
    }
    if (map_ != nullptr && !map_->complete(task_, run_)) {
      throw Interrupted("interrupted: the rows are whole, the pictures are not written");
    }
    return state_;
  }

 private:
  void go_on() {
    if (!sink_.complete()) {
      task_.source->skip(state_.rows, state_.digest);
      while (next_block()) {
      }
    }
    if (Progress::interrupted()) {
      return;
    }
    if (state_.rows == 0) {
      sink_.write(header());
    }
    sink_.finish(state_, rows_.header(state_.rows));
  }

  /// False at the end and after an interrupt.
  bool next_block() {
    const double begun = seconds_now();
    read_block();
    if (block_.size == 0 || Progress::interrupted()) {
      return false;
    }
    if (!write_block()) {
      return false;
    }
    size_.learn(seconds_now() - begun);
    return progress_.goes_on(static_cast<double>(state_.rows));
  }

  /// False after an interrupt.
  bool write_block() {
    run_(block_);
    const auto& pieces = rows_.rows(block_);
    if (Progress::interrupted()) {
      return false;  // what is in hand may have gaps
    }
    if (state_.rows == 0) {
      sink_.write(header());
    }
    for (const std::string& piece : pieces) {
      sink_.write(piece);
    }
    if (map_ != nullptr) {
      map_->add(block_);
    }
    state_.add(block_);
    sink_.reached(state_);
    return true;
  }

  /// The rows before a wrong entry of the block.
  void keep_before(Index entry) {
    block_.cut(entry);
    if (entry > 0) {
      write_block();
    }
  }

  void read_block() {
    try {
      task_.source->fill(block_, size_.value());
    } catch (const UsageError& error) {
      leave_refused(error.what());
    }
  }

  [[nodiscard]] std::string header() const {
    return rows_.header(task_.source->total().value_or(0));
  }

  [[noreturn]] void leave_refused(const std::string& reason) {
    const std::string left = sink_.leave();
    throw UsageError(state_.rows == 0 ? reason : fmt::format("{}; {}", reason, left));
  }

  const SweepTask& task_;
  RowSink& sink_;
  SweepMap* map_;
  Progress progress_;
  SweepRun run_;
  RowWriter rows_;
  BlockSize size_;
  SweepBlock block_;
  SweepState state_;
};

}  // namespace

ExitCode run_sweep(const Settings& settings, Output& output) {
  const SweepTask task = sweep_task(settings);
  const bool rows_on_standard_output = goes_to_standard_output(task);
  const bool json = settings.flag("json");
  if (rows_on_standard_output && json) {
    throw UsageError("json and the rows would both go to standard output: give --output FILE");
  }
  std::optional<SweepMap> map;
  if (wants_pictures(settings)) {
    map.emplace(task);
    prepare_pictures(settings);
  }
  const double begun = seconds_now();
  const std::unique_ptr<RowSink> sink = open_rows(task);
  SweepSummary summary;
  summary.resumed_at = sink->found().rows;
  summary.state = Sweep(task, *sink, map ? &*map : nullptr)();
  summary.wall_time_s = seconds_now() - begun;
  if (map) {
    write_pictures(settings, Command::sweep, sweep_page(task, summary, *map), output);
  }
  if (!rows_on_standard_output) {
    output.print(
        json ? sweep_json(task, summary)
             : sweep_text(task, summary, settings.text("title"), style_for_standard_output()));
  }
  return exit_done;
}

}  // namespace stillpoint::cli
