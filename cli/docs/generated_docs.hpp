// SPDX-License-Identifier: MIT
#pragma once

#include <string>

/// Documents generated from the table of options or by the library, so that they cannot drift from
/// the program.
namespace stillpoint::cli {

/// The manual page stillpoint(1), in roff.
[[nodiscard]] std::string man_page();

/// Completions of the commands and options for a shell.
[[nodiscard]] std::string bash_completion();
[[nodiscard]] std::string zsh_completion();
[[nodiscard]] std::string fish_completion();

/// The JSON Schema (draft 2020-12) of scene files.
[[nodiscard]] std::string scene_schema();

/// The tables of docs/theory.md sections 12 and 13: the largest tolerance of each arrival, and with
/// a residual.
[[nodiscard]] std::string tolerance_tables();

}  // namespace stillpoint::cli
