// SPDX-License-Identifier: MIT
#pragma once

#include <stillpoint/sweep/state.hpp>

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <utility>

namespace stillpoint::sweep {

/// The rows of a sweep that ended early.
struct LeftRows {
  std::int64_t count{0};
  std::optional<std::string>
      file{};  ///< where they wait to be resumed; else they are written for good
};

/// "149 rows are kept in rows.csv.part"
[[nodiscard]] std::string description(const LeftRows& left);

/// Where the rows of a sweep go: this one keeps none, those that derive from it do.
class RowSink {
 public:
  RowSink() = default;
  explicit RowSink(SweepState found) : found_(std::move(found)) {}
  RowSink(const RowSink&) = delete;
  RowSink& operator=(const RowSink&) = delete;
  virtual ~RowSink() = default;

  /// What an interrupted sweep had written.
  [[nodiscard]] const SweepState& found() const { return found_; }

  /// This and the next two throw records::FileError if the rows cannot be written.
  virtual void write(std::string_view /*bytes*/) {}
  /// What was written makes up `state`, from where a sweep can be resumed.
  virtual void reached(const SweepState& /*state*/) {}
  /// Everything is written. `header` replaces the beginning, and is as long as what is there.
  virtual void finish(std::string_view /*header*/) {}

  /// The sweep ends early: keeps what can be resumed. Further calls change nothing.
  virtual LeftRows leave() { return {}; }

 protected:
  /// When the file is opened.
  void set_found(const SweepState& found) { found_ = found; }

 private:
  SweepState found_;
};

}  // namespace stillpoint::sweep
