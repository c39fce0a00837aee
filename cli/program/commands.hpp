// SPDX-License-Identifier: MIT
#pragma once

#include "options/command_line.hpp"
#include "options/settings.hpp"
#include "output.hpp"

#include <stillpoint/design/design.hpp>
#include <stillpoint/design/record_design.hpp>
#include <stillpoint/report/report.hpp>

namespace stillpoint::cli {

/// The exit codes, fixed for scripts.
enum ExitCode : int {
  exit_done = 0,
  exit_wrong_input = 2,
  exit_infeasible = 3,
  exit_check_failed = 4,
  exit_interrupted = 130,  ///< the shells' code for SIGINT
};

/// Runs a command that has settings and hands what it has to say to `output`, uncommitted. Wrong
/// input leaves as an exception. A sweep sends its rows to their file or to standard output as they
/// are computed; its exception says which of them are kept.
ExitCode run(Command command, const Settings& settings, Output& output);

/// Those with a file of their own.
ExitCode run_sweep(const Settings& settings, Output& output);
ExitCode run_merge(const MergeFiles& files, Output& output);
ExitCode run_accuracy(const Settings& settings, Output& output);

/// What design and region have to say, before anything is shown; of a design for a hit, see
/// designs_under_records.
[[nodiscard]] report::DesignReport design_report(const Settings& settings);
[[nodiscard]] report::RegionReport region_report(const Settings& settings);

/// 3 without an admissible design, 4 where the cross-check failed, else 0.
[[nodiscard]] ExitCode exit_code(const design::DesignResult& result);
[[nodiscard]] ExitCode exit_code(const design::RecordDesign& result);

}  // namespace stillpoint::cli
