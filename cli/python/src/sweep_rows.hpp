// SPDX-License-Identifier: MIT
#pragma once

#include "result.hpp"

#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace stillpoint::python {

/// What sweep found, with its rows if they are in memory.
class Sweep final : public Result {
 public:
  using Result::Result;
};

/// The whole sweep without rows, of all its parts.
[[nodiscard]] std::unique_ptr<Sweep> merged_reduction(const std::vector<std::string>& parts);

/// All rows of a sweep, in a file or, of the format npy, in memory.
[[nodiscard]] std::unique_ptr<Sweep> merged_rows(const std::vector<std::string>& parts,
                                                 const std::optional<std::string>& output);

}  // namespace stillpoint::python
