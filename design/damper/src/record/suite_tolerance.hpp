// SPDX-License-Identifier: MIT
#pragma once

#include "record/suite_search.hpp"

#include <optional>

namespace stillpoint::design {

/// A damper with the largest box within the limits that was found.
struct LargestBox {
  double scale{0};  ///< of the tolerance of the request
  VerifiedBox verified;
};

/// At most `most` times the tolerance of the request. Empty if not even an exact damper was found.
[[nodiscard]] std::optional<LargestBox> largest_box(const Suite& suite,
                                                    const RecordDesignRequest& task,
                                                    SuiteFrictions frictions, double most,
                                                    SuiteWatch& watch);

}  // namespace stillpoint::design
