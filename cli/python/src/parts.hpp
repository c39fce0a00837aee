// SPDX-License-Identifier: MIT
#pragma once

#include <pybind11/pybind11.h>

namespace stillpoint::python {

/// stillpoint.InputError, a ValueError, with the text that the program prints, for any wrong input.
void add_errors(pybind11::module_& module);
/// What each other file adds to the module.
void add_commands(pybind11::module_& module);
void add_sweep(pybind11::module_& module);
void add_records(pybind11::module_& module);
void add_result(pybind11::module_& module);

}  // namespace stillpoint::python
