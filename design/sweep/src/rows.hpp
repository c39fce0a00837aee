// SPDX-License-Identifier: MIT
#pragma once

#include "block.hpp"

#include <stillpoint/sweep/spec.hpp>

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

namespace stillpoint::sweep {

/// Turns blocks into bytes, on several threads.
class RowWriter {
 public:
  explicit RowWriter(const SweepSpec& spec);

  /// The bytes before `rows` entries.
  [[nodiscard]] std::string header(std::int64_t rows) const;
  /// The bytes in order, valid until the next call.
  [[nodiscard]] const std::vector<std::string>& rows(const SweepBlock& block);

 private:
  const std::vector<Quantity>& columns_;
  const std::optional<SweepUnits>& units_;
  RowFormat format_;
  int threads_;
  std::vector<std::string> records_;  ///< their names as cells
  std::vector<std::string> pieces_;
};

}  // namespace stillpoint::sweep
