// SPDX-License-Identifier: MIT
#pragma once

#include "sweep_block.hpp"

#include <stillpoint/core/outcome.hpp>

#include <array>
#include <cstdint>

namespace stillpoint::cli {

/// How far a sweep is.
struct SweepState {
  static constexpr std::size_t outcome_count = static_cast<std::size_t>(Outcome::running) + 1;

  std::int64_t rows{0};
  std::uint64_t digest{0};                             ///< of the entries, SweepSource::digest
  std::array<std::int64_t, outcome_count> outcomes{};  ///< how many entries ended so
  std::int64_t feasible{0};                            ///< of designs

  /// With the results of one block more.
  void add(const SweepBlock& block, std::uint64_t digest_behind_it);
};

}  // namespace stillpoint::cli
