// SPDX-License-Identifier: MIT
#pragma once

#include "run_program.hpp"

namespace stillpoint::browser_test {

/// What a browser without a window left behind.
struct Visit {
  int exit_code{-1};  ///< 124: not done in time
  std::string out;
  std::string console;  ///< what the page said there, line by line
};

/// Opens a file of the sandbox, with its own profile there.
[[nodiscard]] Visit visit(const cli_test::Sandbox& sandbox, const std::string& file,
                          const cli_test::Arguments& options);

}  // namespace stillpoint::browser_test
