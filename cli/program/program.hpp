// SPDX-License-Identifier: MIT
#pragma once

namespace stillpoint::cli {

/// The whole program: parses, runs one command, writes what was asked for. Returns the exit code;
/// never throws.
int run(int argc, const char* const* argv);

}  // namespace stillpoint::cli
