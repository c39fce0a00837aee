// SPDX-License-Identifier: MIT
#pragma once

#include "options/settings.hpp"

namespace stillpoint::cli {

/// What --help says about a command besides its options.
struct CommandHelp {
  Command command;
  std::string_view summary;
  std::string_view examples;              ///< and what else is printed below the options
  std::vector<std::string_view> words{};  ///< its possible arguments; empty: a scene
};

/// Every command, in the order of --help.
[[nodiscard]] std::span<const CommandHelp> all_commands();

/// What --help says about the program.
[[nodiscard]] std::string_view program_about();

/// The files of `sweep merge OUT PART...`.
struct MergeFiles {
  std::string output;
  std::vector<std::string> parts;
};

/// What the command line asks for.
struct Invocation {
  Command command{Command::design};
  Settings flags;
  std::optional<std::string> scene;  ///< path or "-"; of init and explore, one of their words
  std::optional<MergeFiles> merge;   ///< for sweep: join parts, and do nothing else
  std::optional<std::string> reply;  ///< --help or --version: print this, and do nothing else
};

/// What `stillpoint` without arguments prints.
[[nodiscard]] std::string short_help();

/// Throws UsageError or InputError for anything that is not understood.
[[nodiscard]] Invocation parse_command_line(int argc, const char* const* argv);

}  // namespace stillpoint::cli
