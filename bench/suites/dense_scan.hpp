// SPDX-License-Identifier: MIT
#pragma once

#include <stillpoint/design/record_design.hpp>

#include <cstdint>

namespace stillpoint::bench {

struct DenseBest {
  design::SuiteDamper damper;
  double value{
      0};  ///< of the objective; infinite where all points are worse than the design by 5 %
  std::int64_t points{0};
};

/// The best of about 10^6 dampers, computed from the kernel's responses alone: a third on a grid
/// even in sqrt(f), sqrt(delta) and 1/p over the box of the search, a third on a finer one about
/// the best of those, a third about the design, which is `found` and has that value. `request` as a
/// RecordDesign has it.
[[nodiscard]] DenseBest dense_best(const design::RecordDesignRequest& request,
                                   const design::SuiteDamper& found, double value);

}  // namespace stillpoint::bench
