// SPDX-License-Identifier: MIT
#pragma once

#include <stillpoint/design/design_result.hpp>
#include <stillpoint/design/part.hpp>

#include <vector>

namespace stillpoint::design {

struct Choice {
  /// The design with the best part, without a search. If no part is admissible there is no finding;
  /// `reason` says so, and `mends` are those of the parts.
  DesignResult result;
  std::vector<RatedPart> parts;  ///< all of them, best first
};

}  // namespace stillpoint::design
