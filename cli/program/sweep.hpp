// SPDX-License-Identifier: MIT
#pragma once

#include "exit_code.hpp"
#include "output.hpp"
#include "settings.hpp"

namespace stillpoint::cli {

/// Runs the command sweep: the rows go to their file or to standard output as they are computed,
/// the report to `output`. Wrong input and an interrupt leave as an exception that says what is
/// kept.
ExitCode run_sweep(const Settings& settings, Output& output);

}  // namespace stillpoint::cli
