// SPDX-License-Identifier: MIT
#pragma once

#include "sweep_state.hpp"

#include <optional>
#include <string>

namespace stillpoint::cli {

/// What is known of an unfinished file beside it: so many of its bytes are whole rows.
struct Checkpoint {
  std::string task;  ///< SweepTask::identity
  SweepState state;
  std::int64_t bytes{0};
  bool complete{false};  ///< the file only lacks its name
};

/// Empty where there is no such file. Throws UsageError where it is no checkpoint.
[[nodiscard]] std::optional<Checkpoint> read_checkpoint(const std::string& path);

/// Replaces the file in one step, so that the old or the new one is there whenever the program
/// ends. 0 or the error.
[[nodiscard]] int write_checkpoint(const std::string& path, const Checkpoint& checkpoint);

/// The first thing in which the tasks differ, "f was 0:1:10, is 0:1:20"; empty where they are one.
[[nodiscard]] std::string difference(const std::string& old_task, const std::string& new_task);

}  // namespace stillpoint::cli
