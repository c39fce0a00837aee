// SPDX-License-Identifier: MIT
#pragma once

// The search of a whole task: with constant friction alone, with a notch alone, with both.

#include "record/suite_search.hpp"

#include <stillpoint/design/record_design_result.hpp>

#include <optional>

namespace stillpoint::design {

struct ChosenBox {
  VerifiedBox verified;
  double scale{1};  ///< of the tolerance of the request
};

/// The best for the completed request of `result`, which gets what there is to say if no damper has
/// the box.
[[nodiscard]] std::optional<ChosenBox> searched(const Suites& suite, RecordDesign& result,
                                                SuiteWatch& watch);

}  // namespace stillpoint::design
