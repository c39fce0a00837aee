// SPDX-License-Identifier: MIT
#include <stillpoint/core/seconds.hpp>
#include <stillpoint/sweep/run.hpp>
#include <stillpoint/sweep/sink.hpp>

#include "block.hpp"
#include "rows.hpp"
#include "source.hpp"
#include "step.hpp"

#include <stillpoint/core/for_each_entry.hpp>
#include <stillpoint/records/file_error.hpp>
#include <stillpoint/sweep/checkpoint.hpp>

#include <fmt/format.h>

#include <algorithm>
#include <limits>
#include <optional>

namespace stillpoint::sweep {

namespace {

using Eigen::Index;

constexpr Index most_rows = std::numeric_limits<Index>::max();

/// How many entries are computed at once. A block takes some tenths of a second at most, so a stop
/// takes effect soon however long an entry takes.
class BlockSize {
 public:
  [[nodiscard]] Index value() const { return value_; }

  void learn(double seconds) {
    constexpr double short_s = 0.05;
    constexpr double long_s = 0.3;
    constexpr Index least = 16;     // damped designs take seconds each
    constexpr Index most = 65'536;  // about 5 MB of columns
    if (seconds < short_s) {
      value_ = std::min(2 * value_, most);
    } else if (seconds > long_s) {
      value_ = std::max(value_ / 2, least);
    }
  }

 private:
  Index value_{16};
};

class Sweep {
 public:
  Sweep(const SweepSpec& spec, RowSink& sink, const SweepWatch& watch)
      : spec_(spec),
        sink_(sink),
        watch_(watch),
        source_(spec.list ? list_source(spec, watch.stop) : grid_source(spec)),
        step_(spec, watch.stop),
        rows_(spec),
        own_(own_entries(spec)),
        state_(sink.found()) {
    if (spec.reduction) {
      reducer_.emplace(spec, state_.reduction);
      state_.reduction = reducer_->result();
    }
  }

  /// False after a stop.
  bool write_rows() {
    source_->skip(own_.first + state_.rows,
                  state_.rows > 0 ? std::optional(state_.digest) : std::nullopt);
    while (next_block()) {
    }
    if (stopped()) {
      sink_.leave();
      return false;
    }
    if (state_.rows == 0 && !reducer_) {
      write_header();
    }
    if (spec_.part) {
      require_whole();
      Checkpoint complete = beginning(spec_);
      complete.state = state_;
      sink_.write(seal(complete));
    }
    sink_.finish(reducer_ ? "" : rows_.header(state_.rows));
    return true;
  }

  /// False after a stop.
  bool complete_map() {
    return watch_.map == nullptr || watch_.map->complete(spec_, step_, watch_.stop);
  }

  [[nodiscard]] const SweepState& state() const { return state_; }

 private:
  [[nodiscard]] bool stopped() const { return watch_.stop.stop_requested(); }

  /// False at the end and after a stop.
  bool next_block() {
    const double begun = seconds_now();
    source_->fill(block_, std::min(size_.value(), own_.count.value_or(most_rows) - state_.rows));
    if (block_.size == 0 || stopped() || !compute()) {
      return false;
    }
    write();
    size_.learn(seconds_now() - begun);
    if (watch_.progress) {
      watch_.progress(state_);
    }
    return !stopped();
  }

  /// False after a stop: what is in the block then may have gaps. Of a block with an entry that is
  /// refused, the rows before it are written.
  bool compute() {
    try {
      step_(block_);
    } catch (const EntryError& error) {
      const SweepBlock refused = block_;
      block_.cut(error.entry());
      if (error.entry() > 0 && compute()) {
        write();
      }
      source_->refuse(refused, error.entry(), error.what());
    }
    return !stopped();
  }

  void write() {
    if (reducer_) {
      reducer_->add(block_);
      state_.reduction = reducer_->result();
    } else {
      write_rows_of_block();
    }
    if (watch_.map != nullptr) {
      watch_.map->add(block_);
    }
    state_.add(block_);
    sink_.reached(state_);
  }

  void write_rows_of_block() {
    const auto& pieces = rows_.rows(block_);
    if (state_.rows == 0) {
      write_header();
    }
    for (const std::string& piece : pieces) {
      put(piece);
    }
  }

  void write_header() {
    put(rows_.header(own_.count.value_or(0)));
    state_.header = state_.bytes;
  }

  void put(std::string_view bytes) {
    sink_.write(bytes);
    state_.bytes += static_cast<std::int64_t>(bytes.size());
  }

  void require_whole() const {
    if (state_.rows != own_.count) {
      throw records::FileError({.kind = "list", .path = spec_.list->source()},
                               "has become shorter since the sweep began");
    }
  }

  const SweepSpec& spec_;
  RowSink& sink_;
  const SweepWatch& watch_;
  std::unique_ptr<SweepSource> source_;
  SweepStep step_;
  RowWriter rows_;
  OwnEntries own_;
  BlockSize size_;
  SweepBlock block_;
  SweepState state_;
  std::optional<Reducer> reducer_;  ///< takes the rows, which are then not written
};

}  // namespace

SweepSummary run(const SweepSpec& spec, RowSink& sink, const SweepWatch& watch) {
  const double begun = seconds_now();
  require_valid(spec);
  Sweep sweep(spec, sink, watch);
  SweepSummary summary;
  summary.resumed_at = sink.found().rows;
  try {
    summary.end = sweep.write_rows() ? SweepEnd::complete : SweepEnd::stopped;
  } catch (...) {
    sink.leave();
    throw;
  }
  if (summary.end == SweepEnd::complete && !sweep.complete_map()) {
    summary.end = SweepEnd::stopped_in_map;
  }
  summary.state = sweep.state();
  summary.wall_time_s = seconds_now() - begun;
  return summary;
}

std::string description(const LeftRows& left) {
  if (left.count == 0) {
    return "nothing is written";
  }
  if (!left.file) {
    return "the rows before it are written";
  }
  return fmt::format("{} kept in {}",
                     left.count == 1 ? "1 row is" : fmt::format("{} rows are", left.count),
                     *left.file);
}

}  // namespace stillpoint::sweep
