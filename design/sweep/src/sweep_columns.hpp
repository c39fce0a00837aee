// SPDX-License-Identifier: MIT
#pragma once

#include "sweep_task.hpp"

#include <span>
#include <vector>

namespace stillpoint::cli {

/// What an entry is made of, in the order of the columns.
[[nodiscard]] std::span<const Quantity> sweep_inputs(SweepKind kind);

/// The columns to write: those of --columns; else the inputs that vary and what the kind finds,
/// stop_time only with --times. Throws UsageError for a name that is none.
[[nodiscard]] std::vector<Quantity> sweep_columns(const Settings& settings, SweepKind kind,
                                                  const std::vector<Quantity>& varying);

}  // namespace stillpoint::cli
