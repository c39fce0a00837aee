// SPDX-License-Identifier: MIT
#pragma once

#include <stillpoint/sweep/state.hpp>

#include <cstdint>
#include <optional>
#include <stdexcept>
#include <string>
#include <string_view>

namespace stillpoint::sweep {

/// The rows of a sweep that ended early.
struct LeftRows {
  std::int64_t count{0};
  std::optional<std::string>
      file{};  ///< where they wait to be resumed; else they are written for good
};

/// "149 rows are kept in rows.csv.part"
[[nodiscard]] std::string description(const LeftRows& left);

/// Where the rows of a sweep go.
class RowSink {
 public:
  RowSink() = default;
  RowSink(const RowSink&) = delete;
  RowSink& operator=(const RowSink&) = delete;
  virtual ~RowSink() = default;

  /// What an interrupted sweep had written.
  [[nodiscard]] virtual const SweepState& found() const = 0;
  /// Nothing is left to do but `finish`.
  [[nodiscard]] virtual bool complete() const { return false; }

  /// This and the next two throw records::FileError if the rows cannot be written.
  virtual void write(std::string_view bytes) = 0;
  /// What was written makes up `state`, from where a sweep can be resumed.
  virtual void reached(const SweepState& state) = 0;
  /// Everything is written. `header` replaces the beginning, and is as long as what is there.
  virtual void finish(const SweepState& state, std::string_view header) = 0;

  /// The sweep ends early: keeps what can be resumed. Further calls change nothing.
  virtual LeftRows leave() = 0;
};

/// Where no rows go.
class NoRows : public RowSink {
 public:
  NoRows() = default;
  /// They are there already.
  explicit NoRows(const SweepState& whole) : found_(whole), complete_(true) {}

  [[nodiscard]] const SweepState& found() const override { return found_; }
  [[nodiscard]] bool complete() const override { return complete_; }
  void write(std::string_view /*bytes*/) override {}
  void reached(const SweepState& /*state*/) override {}
  void finish(const SweepState& /*state*/, std::string_view /*header*/) override {}
  LeftRows leave() override { return {}; }

 private:
  SweepState found_;
  bool complete_{false};
};

/// Another sweep left files, or is still writing them, and this sweep must not touch them.
class LeftoverError : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

}  // namespace stillpoint::sweep
