// SPDX-License-Identifier: MIT
#pragma once

#include "pulse/region.hpp"

#include <stillpoint/design/search.hpp>

#include <optional>

namespace stillpoint::design {

/// The best point, in the units of the region, and the optimum found without NLopt.
struct PulseOptimum {
  SearchResult found;
  Island island;        ///< in which it lies
  double searched{0};   ///< the objective at the best f that NLopt saw
  double bracketed{0};  ///< the same along f alone
};

/// Empty if the region is not feasible. The better of both is the answer.
[[nodiscard]] std::optional<PulseOptimum> search(const PulseRegion& region,
                                                 const SearchOptions& options);

}  // namespace stillpoint::design
