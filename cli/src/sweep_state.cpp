// SPDX-License-Identifier: MIT
#include "sweep_state.hpp"

namespace stillpoint::cli {

void SweepState::add(const SweepBlock& block, std::uint64_t digest_behind_it) {
  rows += block.size;
  digest = digest_behind_it;
  if (block[Quantity::outcome].size() == block.size) {
    for (const double outcome : block[Quantity::outcome]) {
      ++outcomes[static_cast<std::size_t>(outcome)];
    }
  }
  if (block[Quantity::feasible].size() == block.size) {
    feasible += static_cast<std::int64_t>(block[Quantity::feasible].sum());
  }
}

}  // namespace stillpoint::cli
