// SPDX-License-Identifier: MIT
#pragma once

#include "block.hpp"

#include <stillpoint/sweep/spec.hpp>

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

namespace stillpoint::sweep {

/// The names of the columns, in one line.
[[nodiscard]] std::string csv_header(const std::vector<Quantity>& columns);

/// The entries begin <= i < end, a line each: numbers as the shortest decimals that read back to
/// the same double, nothing for a value that does not exist or never comes.
void append_csv(const SweepBlock& block, const std::vector<Quantity>& columns, Eigen::Index begin,
                Eigen::Index end, std::string& text);

/// The header of a NumPy file, version 1.0, of records with the columns as fields: 8-byte floats,
/// but bytes for outcome and feasible. Its length does not depend on `rows`.
[[nodiscard]] std::string npy_header(const std::vector<Quantity>& columns, std::int64_t rows);

/// The entries begin <= i < end, a packed record each.
void append_npy(const SweepBlock& block, const std::vector<Quantity>& columns, Eigen::Index begin,
                Eigen::Index end, std::string& bytes);

/// Turns blocks into bytes, on several threads.
class RowWriter {
 public:
  explicit RowWriter(const SweepSpec& spec)
      : columns_(spec.columns), format_(spec.format), threads_(spec.threads) {}

  /// What comes before `rows` entries.
  [[nodiscard]] std::string header(std::int64_t rows) const;
  /// The bytes in order, valid until the next call.
  [[nodiscard]] const std::vector<std::string>& rows(const SweepBlock& block);

 private:
  const std::vector<Quantity>& columns_;
  RowFormat format_;
  int threads_;
  std::vector<std::string> pieces_;
};

}  // namespace stillpoint::sweep
