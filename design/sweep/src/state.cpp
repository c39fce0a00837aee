// SPDX-License-Identifier: MIT
#include <stillpoint/sweep/state.hpp>

#include "block.hpp"

#include <algorithm>

namespace stillpoint::sweep {

void SweepBlock::cut(Eigen::Index count) {
  for (Eigen::ArrayXd& column : columns) {
    column.conservativeResize(std::min(count, column.size()));
  }
  const auto kept = static_cast<std::size_t>(count);
  lines.resize(std::min(kept, lines.size()));
  digests.resize(std::min(kept, digests.size()));
  size = count;
}

std::uint64_t digest(const Excitation& excitation) {
  Digest digest;
  if (const auto* const record = std::get_if<Record>(&excitation)) {
    digest.add(record->step);
    std::ranges::for_each(record->values, [&](double value) { digest.add(value); });
    std::ranges::for_each(record->times, [&](double time) { digest.add(time); });
  }
  return digest.value();
}

std::uint64_t digest(const std::vector<design::Part>& parts) {
  Digest digest;
  for (const design::Part& part : parts) {
    digest.add(part.f);
    digest.add(part.delta);
  }
  return digest.value();
}

void SweepState::add(const SweepBlock& block) {
  rows += block.size;
  digest = block.digest();
  if (block[Quantity::outcome].size() == block.size) {
    for (const double outcome : block[Quantity::outcome]) {
      ++outcomes[static_cast<std::size_t>(outcome)];
    }
  }
  if (block[Quantity::feasible].size() == block.size) {
    feasible += static_cast<std::int64_t>(block[Quantity::feasible].sum());
  }
}

}  // namespace stillpoint::sweep
