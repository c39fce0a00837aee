// SPDX-License-Identifier: MIT
#pragma once

#include "record/suite.hpp"

#include <cstddef>
#include <cstdint>
#include <vector>

namespace stillpoint::design {

/// The points of a grid, so many to a side, that no neighbour betters, best first; at most `most`.
[[nodiscard]] std::vector<std::size_t> valleys(std::int64_t points, std::size_t variables,
                                               const std::vector<SuiteRank>& ranks,
                                               std::size_t most);

}  // namespace stillpoint::design
