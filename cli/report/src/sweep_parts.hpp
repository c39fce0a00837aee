// SPDX-License-Identifier: MIT
#pragma once

// What the reports of sweeps with and without rows share.

#include <stillpoint/report/document.hpp>
#include <stillpoint/sweep/state.hpp>

#include <nlohmann/json.hpp>

#include <cstdint>
#include <string>
#include <string_view>

namespace stillpoint::report {

inline constexpr std::string_view reduction_schema = "stillpoint/sweep-reduction/1";

/// Of everything else in the report of a part.
[[nodiscard]] std::uint64_t digest_of(const nlohmann::ordered_json& report);

[[nodiscard]] nlohmann::ordered_json outcomes_json(const sweep::SweepState::Counts& outcomes);
/// Throws nlohmann's exceptions where one is missing.
void outcomes_from_json(const nlohmann::ordered_json& counts, sweep::SweepState::Counts& outcomes);

/// With how many entries ended in each way.
[[nodiscard]] Document document_of(std::string title, const sweep::SweepState& state, bool design);

}  // namespace stillpoint::report
