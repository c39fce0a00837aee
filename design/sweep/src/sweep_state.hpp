// SPDX-License-Identifier: MIT
#pragma once

#include "sweep_block.hpp"
#include "sweep_outcome.hpp"

#include <array>
#include <cstdint>

namespace stillpoint::cli {

/// How far a sweep is.
struct SweepState {
  std::int64_t rows{0};
  std::uint64_t digest{0};                                   ///< of the entries, SweepBlock::digest
  std::array<std::int64_t, sweep_outcome_count> outcomes{};  ///< how many entries ended so
  std::int64_t feasible{0};                                  ///< of designs

  /// With the results of one block more.
  void add(const SweepBlock& block);
};

}  // namespace stillpoint::cli
