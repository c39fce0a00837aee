// SPDX-License-Identifier: MIT
#pragma once

#include "exit_code.hpp"
#include "output.hpp"
#include "settings.hpp"

#include <stillpoint/design/design.hpp>

namespace stillpoint::cli {

/// Each runs one command and hands what it has to say to `output`, uncommitted. Wrong input leaves
/// as an exception.
ExitCode run_design(const Settings& settings, Output& output);
ExitCode run_region(const Settings& settings, Output& output);
ExitCode run_simulate(const Settings& settings, Output& output);
ExitCode run_accuracy(const Settings& settings, Output& output);

/// 3 without an admissible design, 4 where the cross-check failed, else 0.
[[nodiscard]] ExitCode exit_code(const design::DesignResult& result);

}  // namespace stillpoint::cli
