// SPDX-License-Identifier: MIT
#pragma once

// The load cases of a design.

#include "input/motion.hpp"

#include <stillpoint/design/record_design.hpp>

#include <cstddef>

namespace stillpoint::cli {

/// A case with what all have in common.
struct GivenCase {
  std::string name;
  Settings settings;
};

/// Those of --cases; without it the only one, which has no name. Throws InputError and UsageError.
[[nodiscard]] std::vector<GivenCase> cases_of(const Settings& settings);

/// Throws UsageError unless there is a velocity, a pulse or records, one of them, with the options
/// that shape it and no others; those of the excitation of a scene are for a motion.
void require_one_load(const Settings& settings);

/// In the units of `start`. Without `one_period` records are not scaled to their spectrum at the
/// period of `start`. Throws InputError, UsageError and FileError.
[[nodiscard]] design::LoadCase load_case(const GivenCase& given, const MotionInput& start,
                                         bool one_period);

/// What is minimised unless --objective says.
[[nodiscard]] design::SuiteObjective usual_objective(const std::vector<design::LoadCase>& cases);

/// The place of --objective-case. Throws InputError.
[[nodiscard]] std::optional<std::size_t> objective_case(const Settings& settings,
                                                        const std::vector<design::LoadCase>& cases);

}  // namespace stillpoint::cli
