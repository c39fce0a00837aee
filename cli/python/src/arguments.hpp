// SPDX-License-Identifier: MIT
#pragma once

#include "options/settings.hpp"

#include <pybind11/pybind11.h>

namespace stillpoint::python {

/// What help() says: the signature as Python reads it, `about`, and the options in the order of
/// --help.
[[nodiscard]] std::string documentation(cli::Command command, std::string_view about);

/// For each option of a command: its keyword, its type in a stub and its help.
[[nodiscard]] pybind11::list options(const std::string& command);

/// A UserWarning for each value that makes no sense with the others, and for each file in a folder
/// that is not a record.
void warn_of_doubts(const cli::Settings& settings, cli::Command command);

/// The settings that the program would make from a scene (a path, a dict or None) and flags of
/// these names. None stands for an option that is not given. Throws InputError, UsageError and
/// FileError.
[[nodiscard]] cli::Settings settings(cli::Command command, const pybind11::object& scene,
                                     const pybind11::dict& options);

}  // namespace stillpoint::python
