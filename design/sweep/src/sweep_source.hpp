// SPDX-License-Identifier: MIT
#pragma once

#include "axis.hpp"
#include "list_reader.hpp"
#include "sweep_block.hpp"

#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace stillpoint::cli {

/// Where the entries of a sweep come from, block by block.
class SweepSource {
 public:
  SweepSource() = default;
  SweepSource(const SweepSource&) = delete;
  SweepSource& operator=(const SweepSource&) = delete;
  SweepSource(SweepSource&&) = delete;
  SweepSource& operator=(SweepSource&&) = delete;
  virtual ~SweepSource() = default;

  /// The inputs of the next entries, `most` of them or what is left; size 0 at the end. After an
  /// interrupt what it holds is of no use. Throws UsageError where the next entry is wrong; those
  /// before it were given first.
  virtual void fill(SweepBlock& block, Eigen::Index most) = 0;

  /// Passes over the first `entries`, before the first fill. Throws UsageError where they are not
  /// those that `digest` was of.
  virtual void skip(std::int64_t entries, std::uint64_t digest) = 0;

  /// All entries, where that is known.
  [[nodiscard]] virtual std::optional<std::int64_t> total() const = 0;

  /// How a message names entry i of the block.
  [[nodiscard]] virtual std::string place(const SweepBlock& block, Eigen::Index i) const = 0;
};

/// What one input of a sweep may be.
struct SweepAxis {
  Quantity quantity{};
  Axis axis;
};

/// All combinations, the last axis fastest. Throws UsageError where there are more than 1e15.
[[nodiscard]] std::unique_ptr<SweepSource> grid_source(std::vector<SweepAxis> axes);

/// The rows of a list; `fixed` has one value each of what is no column.
[[nodiscard]] std::unique_ptr<SweepSource> list_source(ListReader list,
                                                       std::vector<SweepAxis> fixed);

}  // namespace stillpoint::cli
