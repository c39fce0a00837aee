// SPDX-License-Identifier: MIT
#pragma once

#include <stillpoint/sweep/state.hpp>

#include <optional>
#include <string>

namespace stillpoint::sweep {

/// What a file beside FILE.part says about it.
struct Checkpoint {
  std::string task;  ///< SweepSpec::identity
  SweepState state;
  std::int64_t bytes{0};  ///< of the header and whole rows
  bool complete{false};   ///< only the name of the file is missing
};

/// Throws InputError unless the identity of a sweep is a JSON object.
void require_task(const std::string& task);

/// Empty if there is no such file. Throws LeftoverError if it is not a checkpoint.
[[nodiscard]] std::optional<Checkpoint> read_checkpoint(const std::string& path);

/// Replaces the file in one step, so the old or the new one is there whenever the program ends. 0
/// or the error.
[[nodiscard]] int write_checkpoint(const std::string& path, const Checkpoint& checkpoint);

/// The first difference of two tasks, "f was 0:1:10, is 0:1:20"; empty if they are the same.
[[nodiscard]] std::string difference(const std::string& old_task, const std::string& new_task);

}  // namespace stillpoint::sweep
