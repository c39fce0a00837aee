// SPDX-License-Identifier: MIT
#pragma once

// What the reports of sweeps with and without rows share.

#include <stillpoint/report/document.hpp>
#include <stillpoint/sweep/state.hpp>

#include <nlohmann/json.hpp>

namespace stillpoint::report {

[[nodiscard]] nlohmann::ordered_json outcomes_json(const sweep::SweepState& state);
/// Throws nlohmann's exceptions where one is missing.
void outcomes_from_json(const nlohmann::ordered_json& outcomes, sweep::SweepState& state);

/// How many entries ended in each way, as a sentence and individually.
void add_outcomes(Document& document, const sweep::SweepState& state, bool design);

}  // namespace stillpoint::report
