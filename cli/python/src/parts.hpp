// SPDX-License-Identifier: MIT
#pragma once

#include <pybind11/pybind11.h>

namespace stillpoint::python {

/// What each file adds to the module.
void add_commands(pybind11::module_& module);
void add_sweep(pybind11::module_& module);
void add_records(pybind11::module_& module);

}  // namespace stillpoint::python
