// SPDX-License-Identifier: MIT
#pragma once

#include <stillpoint/sweep/quantity.hpp>

#include <Eigen/Core>

#include <array>
#include <cmath>
#include <cstdint>
#include <vector>

namespace stillpoint::sweep {

/// Some consecutive entries of a sweep: an array for each quantity in use.
struct SweepBlock {
  Eigen::Index size{0};
  std::array<Eigen::ArrayXd, quantity_count> columns;
  std::int64_t first{0};            ///< its first entry, counted from 0
  std::vector<std::int64_t> lines;  ///< of a list: where each entry is
  /// For a list, the digest of all entries up to each. A grid always has the same entries.
  std::vector<std::uint64_t> digests;

  Eigen::ArrayXd& operator[](Quantity quantity) { return columns[index(quantity)]; }
  const Eigen::ArrayXd& operator[](Quantity quantity) const { return columns[index(quantity)]; }

  /// Whether the notch holds the mass of an entry although the load goes on.
  [[nodiscard]] bool locks(Eigen::Index entry) const {
    const Eigen::ArrayXd& from = (*this)[Quantity::locked_from];
    return from.size() == size && std::isfinite(from[entry]);
  }
  [[nodiscard]] std::uint64_t digest() const { return digests.empty() ? 0 : digests.back(); }
  /// Keeps the first `count` entries.
  void cut(Eigen::Index count);
};

}  // namespace stillpoint::sweep
