// SPDX-License-Identifier: MIT
#pragma once

#include "sweep_block.hpp"
#include "sweep_task.hpp"

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

namespace stillpoint::cli {

/// The names of the columns, a line.
[[nodiscard]] std::string csv_header(const std::vector<Quantity>& columns);

/// The entries begin <= i < end, a line each: numbers as the shortest decimals that are read back
/// to the last bit, nothing where a value does not exist or never comes.
void append_csv(const SweepBlock& block, const std::vector<Quantity>& columns, Eigen::Index begin,
                Eigen::Index end, std::string& text);

/// The header of a NumPy file, version 1.0, whose records have the columns as fields: 8-byte
/// floats; outcome and feasible are bytes. Its length does not depend on `rows`.
[[nodiscard]] std::string npy_header(const std::vector<Quantity>& columns, std::int64_t rows);

/// The entries begin <= i < end, a packed record each.
void append_npy(const SweepBlock& block, const std::vector<Quantity>& columns, Eigen::Index begin,
                Eigen::Index end, std::string& bytes);

/// Turns whole blocks into bytes, in pieces on several threads.
class RowWriter {
 public:
  explicit RowWriter(const SweepTask& task)
      : columns_(task.columns), format_(task.format), threads_(task.threads) {}

  /// What stands before `rows` entries.
  [[nodiscard]] std::string header(std::int64_t rows) const;
  /// The bytes in order, good until the next call.
  [[nodiscard]] const std::vector<std::string>& rows(const SweepBlock& block);

 private:
  const std::vector<Quantity>& columns_;
  RowFormat format_;
  int threads_;
  std::vector<std::string> pieces_;
};

}  // namespace stillpoint::cli
