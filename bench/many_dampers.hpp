// SPDX-License-Identifier: MIT
#pragma once

#include "free_modes.hpp"

#include <stillpoint/peers/measure.hpp>

#include <stillpoint/core/excitation.hpp>

#include <vector>

namespace stillpoint::bench {

/// Scene S6: what the scan of a record design does, eleven records and 10^4 dampers, on one thread.
struct ManyDampers {
  std::vector<Unit> rows;   ///< the whole scene in the lanes, one by one, and by a peer
  double sampled{0};        ///< this many of the dampers were run one by one; times are scaled
  double samples{0};        ///< of all records
  double error_of_peak{0};  ///< the peer's largest
  double wrong_counts{0};   ///< of the peer's motions, as a part
};

/// `record` is that of S5; the eleven are made from it by scale and step.
[[nodiscard]] ManyDampers many_dampers(const Record& record, const peers::MeasureOptions& options);

}  // namespace stillpoint::bench
