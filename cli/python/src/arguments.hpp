// SPDX-License-Identifier: MIT
#pragma once

#include "settings.hpp"

#include <pybind11/pybind11.h>

namespace stillpoint::python {

/// Whether the command has the option in Python: files that show a report are the program's alone.
[[nodiscard]] bool takes(cli::Command command, const cli::Option& option);

/// What the program would make of a scene (a path, a dict or None) and flags of these names. None
/// stands for an option that is not given. Throws InputError, UsageError and FileError.
[[nodiscard]] cli::Settings settings(cli::Command command, const pybind11::object& scene,
                                     const pybind11::dict& options);

}  // namespace stillpoint::python
