// SPDX-License-Identifier: MIT
#pragma once

#include <pybind11/pybind11.h>

namespace stillpoint::python {

/// What each other file adds to the module.
void add_commands(pybind11::module_& module);
void add_sweep(pybind11::module_& module);
void add_records(pybind11::module_& module);
void add_result(pybind11::module_& module);

}  // namespace stillpoint::python
