// SPDX-License-Identifier: MIT
#pragma once

#include "page.hpp"
#include "sweep_state.hpp"
#include "sweep_task.hpp"

#include <optional>
#include <string>

namespace stillpoint::cli {

/// How a sweep went.
struct SweepSummary {
  SweepState state;
  std::int64_t resumed_at{0};  ///< rows that an interrupted sweep had left
  double wall_time_s{0};       ///< of this run alone
};

/// The report stillpoint/sweep-report/1.
[[nodiscard]] std::string sweep_json(const SweepTask& task, const SweepSummary& summary);

/// The same for people.
[[nodiscard]] std::string sweep_text(const SweepTask& task, const SweepSummary& summary,
                                     const std::optional<std::string>& title, Style style);

}  // namespace stillpoint::cli
