// SPDX-License-Identifier: MIT
#pragma once

#include "page.hpp"

#include <stillpoint/sweep/run.hpp>

#include <optional>
#include <string>

namespace stillpoint::cli {

/// The report stillpoint/sweep-report/1.
[[nodiscard]] std::string sweep_json(const sweep::SweepSpec& spec,
                                     const sweep::SweepSummary& summary);

/// The same for people.
[[nodiscard]] std::string sweep_text(const sweep::SweepSpec& spec,
                                     const sweep::SweepSummary& summary,
                                     const std::optional<std::string>& title, Style style);

}  // namespace stillpoint::cli
