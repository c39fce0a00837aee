// SPDX-License-Identifier: MIT
#pragma once

#include "block.hpp"

#include <stillpoint/sweep/spec.hpp>

#include <cstdint>
#include <memory>
#include <optional>
#include <stop_token>
#include <string>

namespace stillpoint::sweep {

/// Where the entries of a sweep come from, block by block.
class SweepSource {
 public:
  SweepSource() = default;
  SweepSource(const SweepSource&) = delete;
  SweepSource& operator=(const SweepSource&) = delete;
  virtual ~SweepSource() = default;

  /// The inputs of the next entries, `most` of them or what is left; size 0 at the end. Throws
  /// FileError if the next entry of a list is wrong; the entries before it are given first.
  virtual void fill(SweepBlock& block, Eigen::Index most) = 0;

  /// Skips the first `entries`, before the first fill. Throws FileError if a list does not begin
  /// with the entries that `digest`, if given, was of.
  virtual void skip(std::int64_t entries, std::optional<std::uint64_t> digest) = 0;

  /// Throws an error that says where entry i of the block comes from, and `reason`.
  [[noreturn]] virtual void refuse(const SweepBlock& block, Eigen::Index i,
                                   const std::string& reason) const = 0;
};

/// All combinations, the last axis fastest.
[[nodiscard]] std::unique_ptr<SweepSource> grid_source(const SweepSpec& spec);

/// The rows of a list; the axes have the values of what is not a column. After a stop, which a
/// list on standard input may be waiting through, what it gives is incomplete.
[[nodiscard]] std::unique_ptr<SweepSource> list_source(const SweepSpec& spec, std::stop_token stop);

}  // namespace stillpoint::sweep
