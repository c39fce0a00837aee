// SPDX-License-Identifier: MIT
#pragma once

namespace stillpoint::cli {

/// The exit codes, fixed for scripts.
enum ExitCode : int {
  exit_done = 0,
  exit_wrong_input = 2,
  exit_infeasible = 3,
  exit_check_failed = 4,
  exit_interrupted = 130,  ///< as shells have it
};

/// The whole program: parses, runs one command, writes what was asked for. Never throws.
int run(int argc, const char* const* argv);

}  // namespace stillpoint::cli
