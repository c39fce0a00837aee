// SPDX-License-Identifier: MIT
#pragma once

#include "record/suite_maps.hpp"
#include "record/task_along_f.hpp"

#include <stillpoint/design/record_design_result.hpp>

namespace stillpoint::design {

/// Of a task without a damper, into its result: the box on the maps that violates the limits least,
/// and each change that would do.
void tell_what_helps(const Suites& suite, RecordDesign& result, const SuiteGoal& goal,
                     SuiteMaps& maps, const AlongF& along_f, SuiteWatch& watch);

}  // namespace stillpoint::design
