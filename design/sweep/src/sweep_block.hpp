// SPDX-License-Identifier: MIT
#pragma once

#include "sweep_quantity.hpp"

#include <Eigen/Core>

#include <array>
#include <cstdint>
#include <vector>

namespace stillpoint::cli {

/// Some entries of a sweep: what is known of them, an array for each quantity in use.
struct SweepBlock {
  Eigen::Index size{0};
  std::array<Eigen::ArrayXd, quantity_count> columns;
  std::int64_t first{0};            ///< its first entry, counted from 0
  std::vector<std::int64_t> lines;  ///< where each stands in a list; empty in a grid
  /// Of all entries of a list up to each; empty in a grid, whose entries are always the same.
  std::vector<std::uint64_t> digests;

  Eigen::ArrayXd& operator[](Quantity quantity) { return columns[index(quantity)]; }
  const Eigen::ArrayXd& operator[](Quantity quantity) const { return columns[index(quantity)]; }

  [[nodiscard]] std::uint64_t digest() const { return digests.empty() ? 0 : digests.back(); }
  /// Leaves the first `count` entries.
  void cut(Eigen::Index count);
};

}  // namespace stillpoint::cli
