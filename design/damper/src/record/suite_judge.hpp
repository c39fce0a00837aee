// SPDX-License-Identifier: MIT
#pragma once

// A damper that is given: whether its box keeps every limit, and the best part of a catalogue.

#include "record/suite_task_search.hpp"

#include <optional>
#include <vector>

namespace stillpoint::design {

/// What is asked of the box of a damper whatever moves it: that it can be manufactured, and that
/// the loads which must start the mass do. The box is `scale` times that of the task.
[[nodiscard]] std::vector<Constraint> constraints_on(const RecordDesignRequest& task,
                                                     const SuiteDamper& damper, double scale = 1);

/// Of the damper that the completed request of `result` gives, which gets the largest tolerance if
/// the damper itself is admissible. Empty if a damper of its box never rests.
[[nodiscard]] std::optional<ChosenBox> judged(const Suites& suite, RecordDesign& result,
                                              SuiteWatch& watch);

/// Of the parts, which `result` gets best first. Empty if none is admissible.
[[nodiscard]] std::optional<ChosenBox> best_part(const Suites& suite, RecordDesign& result,
                                                 SuiteWatch& watch);

}  // namespace stillpoint::design
