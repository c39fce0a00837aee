// SPDX-License-Identifier: MIT
#pragma once

#include <stillpoint/report/record_design.hpp>
#include <stillpoint/report/report.hpp>

namespace stillpoint::answers {

/// The exit codes, fixed for scripts.
enum ExitCode : int {
  exit_done = 0,
  exit_wrong_input = 2,
  exit_infeasible = 3,
  exit_check_failed = 4,
  exit_interrupted = 130,  ///< the shells' code for SIGINT
};

/// 3 without an admissible design, 4 if the cross-check failed, else 0.
[[nodiscard]] ExitCode exit_code(const report::DesignReport& report);
/// The same; 130 for a search that was interrupted. A region that judges a damper is an answer.
[[nodiscard]] ExitCode exit_code(const report::RecordDesignReport& report);
[[nodiscard]] ExitCode exit_code(const report::RegionReport& report);
/// Of any other answer.
template <class Report>
[[nodiscard]] ExitCode exit_code(const Report& /*report*/) {
  return exit_done;
}

}  // namespace stillpoint::answers
