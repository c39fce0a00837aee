// SPDX-License-Identifier: MIT
#pragma once

namespace stillpoint::cli {

/// The exit codes, fixed for scripts.
enum ExitCode : int {
  exit_done = 0,
  exit_wrong_input = 2,
  exit_infeasible = 3,
  exit_check_failed = 4,
  exit_interrupted = 130,  ///< the shells' code for SIGINT
};

}  // namespace stillpoint::cli
