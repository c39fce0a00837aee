// SPDX-License-Identifier: MIT
#pragma once

#include "options.hpp"
#include "settings.hpp"

#include <optional>
#include <string>

namespace stillpoint::cli {

/// What the command line asks for.
struct Invocation {
  Command command{Command::design};
  Settings flags;
  std::optional<std::string> scene;  ///< path or "-"
  std::optional<std::string> reply;  ///< --help or --version: print this, and nothing else is asked
};

/// Throws UsageError or InputError for anything that is not understood.
[[nodiscard]] Invocation parse_command_line(int argc, const char* const* argv);

}  // namespace stillpoint::cli
