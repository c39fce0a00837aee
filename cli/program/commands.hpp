// SPDX-License-Identifier: MIT
#pragma once

#include "command_line.hpp"
#include "output.hpp"
#include "settings.hpp"

#include <stillpoint/design/design.hpp>
#include <stillpoint/design/record_design.hpp>
#include <stillpoint/report/record_design.hpp>
#include <stillpoint/report/report.hpp>
#include <stillpoint/report/spectrum.hpp>

namespace stillpoint::cli {

/// The exit codes, fixed for scripts.
enum ExitCode : int {
  exit_done = 0,
  exit_wrong_input = 2,
  exit_infeasible = 3,
  exit_check_failed = 4,
  exit_interrupted = 130,  ///< the shells' code for SIGINT
};

/// Each runs one command and hands what it has to say to `output`, uncommitted. Wrong input leaves
/// as an exception. A sweep sends its rows to their file or to standard output as they are
/// computed; its exception says which of them are kept.
ExitCode run_design(const Settings& settings, Output& output);
ExitCode run_region(const Settings& settings, Output& output);
ExitCode run_simulate(const Settings& settings, Output& output);
ExitCode run_spectrum(const Settings& settings, Output& output);
ExitCode run_sweep(const Settings& settings, Output& output);
ExitCode run_merge(const MergeFiles& files, Output& output);
ExitCode run_accuracy(const Settings& settings, Output& output);

/// What they have to say, before anything is shown. A design for a hit or under records, see
/// designs_under_records.
[[nodiscard]] report::DesignReport design_report(const Settings& settings);
[[nodiscard]] report::RecordDesignReport record_design_report(const Settings& settings);
[[nodiscard]] report::RegionReport region_report(const Settings& settings);
[[nodiscard]] report::MotionReport motion_report(const Settings& settings);
[[nodiscard]] report::SpectrumReport spectrum_report(const Settings& settings);

/// 3 without an admissible design, 4 where the cross-check failed, else 0.
[[nodiscard]] ExitCode exit_code(const design::DesignResult& result);
[[nodiscard]] ExitCode exit_code(const design::RecordDesign& result);

}  // namespace stillpoint::cli
