// SPDX-License-Identifier: MIT
#pragma once

#include "run_program.hpp"

#include <iosfwd>

namespace stillpoint::cli_test {

using Texts = std::vector<std::string>;

/// A wrong command, and what the message must contain: the field, the value, the bound.
struct Wrong {
  Arguments arguments;
  Texts says;
  std::string input{};
  std::map<std::string, std::string>
      files{};  ///< that it may read; "/" for a folder, "-> TARGET" for a link
};

/// The commands of a file of tests/cli/program/commands, as people would type them:
///   file NAME TEXT, folder NAME, link NAME TARGET: there is one, for all below
///   task NAME COMMAND: what NAME as the first word of a command below stands for
///   $ COMMAND
///     what its message must contain, a line for each
///     < its standard input
/// where \n, \r, \t, \xNN and \\ stand for characters, \{20 ab} for 20 times ab, and # begins a
/// comment.
[[nodiscard]] std::vector<Wrong> commands_in(const std::string& file);

std::ostream& operator<<(std::ostream& stream, const Wrong& wrong);

/// The files that it may read.
void write_files(const Sandbox& sandbox, const Wrong& wrong);

/// Asserts exit code 2, one line on standard error with all of `says`, nothing on standard output.
void check_refusal(const ProgramRun& run, const Texts& says);

/// The same for a run in `sandbox` with --output on an old report, which must survive like
/// everything else there.
void check_refused(const Sandbox& sandbox, const Wrong& wrong);

}  // namespace stillpoint::cli_test
