// SPDX-License-Identifier: MIT
#pragma once

#include "record/suite_maps.hpp"

#include <stillpoint/design/record_design_result.hpp>

namespace stillpoint::design {

/// Puts the front of stroke and acceleration that the task asks for, from the least stroke to the
/// least acceleration, into the result: of dampers without an error where only the largest box is
/// asked for.
void find_front(const Suites& suite, RecordDesign& result, SuiteMaps& maps, SuiteWatch& watch);

/// A result to be, of that task with dampers that are exact.
[[nodiscard]] RecordDesign without_errors(const RecordDesignRequest& task);

}  // namespace stillpoint::design
