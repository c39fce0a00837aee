// SPDX-License-Identifier: MIT
#pragma once

#include <stillpoint/sweep/outcome.hpp>

#include <array>
#include <cstdint>

namespace stillpoint::sweep {

struct SweepBlock;

/// How far a sweep is.
struct SweepState {
  std::int64_t rows{0};
  std::uint64_t digest{0};                                   ///< of the entries of a list so far
  std::array<std::int64_t, sweep_outcome_count> outcomes{};  ///< how many motions ended this way
  std::int64_t feasible{0};                                  ///< of the design problems

  /// Adds the results of one more block.
  void add(const SweepBlock& block);
};

}  // namespace stillpoint::sweep
