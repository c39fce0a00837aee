// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <string_view>

/// Documents generated from the tables of options and fields or by the library, so that they cannot
/// drift from the program.
namespace stillpoint::cli {

/// The manual page stillpoint(1), in roff.
[[nodiscard]] std::string man_page();

/// Completions of the commands and options for a shell.
[[nodiscard]] std::string bash_completion();
[[nodiscard]] std::string zsh_completion();
[[nodiscard]] std::string fish_completion();

/// The JSON Schema (draft 2020-12) of scene files.
[[nodiscard]] std::string scene_schema();

/// The JSON Schema of the report of that name, "simulation-report-1" say; empty for another name.
[[nodiscard]] std::string report_schema(std::string_view name);

/// The tables of docs/reports.md with the figures of a motion: of any, and under a load besides.
[[nodiscard]] std::string motion_tables();

/// The row of docs/sweep.md that says what the figures of a motion are called in SI units.
[[nodiscard]] std::string sweep_columns_row();

}  // namespace stillpoint::cli
