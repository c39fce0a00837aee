// SPDX-License-Identifier: MIT
#pragma once

#include "options/command_line.hpp"
#include "output.hpp"

namespace stillpoint::cli {

using answers::ExitCode;
using enum answers::ExitCode;

/// Runs a command that has settings and puts its output into `output`, uncommitted. Wrong input
/// throws. A sweep sends its rows to their file or to standard output as they are computed; its
/// exception says which of them are kept.
ExitCode run(Command command, const Settings& settings, Output& output);

/// Those with their own file.
ExitCode run_sweep(const Settings& settings, Output& output);
ExitCode run_accuracy(const Settings& settings, Output& output);
/// Joins the parts of a sweep.
ExitCode run_merge(const MergeFiles& files, Output& output);

}  // namespace stillpoint::cli
