// SPDX-License-Identifier: MIT
#pragma once

#include "run_program.hpp"

#include <iosfwd>
#include <string>
#include <vector>

namespace stillpoint::cli_test {

using Texts = std::vector<std::string>;

/// A wrong command, and what the message must contain: the field, the value, the bound.
struct Wrong {
  Arguments arguments;
  Texts says;
  std::string input{};
};

std::ostream& operator<<(std::ostream& stream, const Wrong& wrong);

/// Asserts exit code 2, one line on standard error with all of `says`, nothing on standard output.
void check_refusal(const ProgramRun& run, const Texts& says);

/// The same for a run in `sandbox`, alone and with --output on an old report, which must survive
/// like everything else there.
void check_refused(const Sandbox& sandbox, const Wrong& wrong,
                   const Surroundings& surroundings = {});

}  // namespace stillpoint::cli_test
