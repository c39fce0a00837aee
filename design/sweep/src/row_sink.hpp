// SPDX-License-Identifier: MIT
#pragma once

#include "sweep_state.hpp"

#include <memory>
#include <string>
#include <string_view>

namespace stillpoint::cli {

struct SweepTask;

/// Where the rows of a sweep go.
class RowSink {
 public:
  RowSink() = default;
  RowSink(const RowSink&) = delete;
  RowSink& operator=(const RowSink&) = delete;
  RowSink(RowSink&&) = delete;
  RowSink& operator=(RowSink&&) = delete;
  virtual ~RowSink() = default;

  /// What is there already, from an interrupted sweep.
  [[nodiscard]] virtual const SweepState& found() const = 0;
  /// Nothing is left to do but `finish`.
  [[nodiscard]] virtual bool complete() const { return false; }

  /// Throws UsageError where it cannot be written; so do the next two.
  virtual void write(std::string_view bytes) = 0;
  /// What was written makes up `state`: a good place to go on from.
  virtual void reached(const SweepState& state) = 0;
  /// All is there. `header`, as long as what stands there, replaces the beginning.
  virtual void finish(const SweepState& state, std::string_view header) = 0;

  /// The sweep ends early. Says what is left of it and what to do, e.g. "nothing is written".
  [[nodiscard]] virtual std::string leave() = 0;
};

/// The file of the task, or standard output. Throws UsageError where it cannot be written, where
/// something is left of an interrupted sweep and the task does not resume it, or where it does and
/// what is left belongs to another task.
[[nodiscard]] std::unique_ptr<RowSink> open_rows(const SweepTask& task);

/// Whether the rows go to standard output.
[[nodiscard]] bool goes_to_standard_output(const SweepTask& task);

}  // namespace stillpoint::cli
