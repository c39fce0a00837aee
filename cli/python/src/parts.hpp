// SPDX-License-Identifier: MIT
#pragma once

#include <pybind11/pybind11.h>

namespace stillpoint::python {

/// What each file adds to the module.
void add_commands(pybind11::module_& module);
void add_sweep(pybind11::module_& module);
void add_peak(pybind11::module_& module);
void add_motions(pybind11::module_& module);
void add_records(pybind11::module_& module);
void add_merge(pybind11::module_& module);

/// A function of METH_FASTCALL | METH_KEYWORDS as a table of methods takes it.
inline PyCFunction as_method(PyObject* (*function)(PyObject*, PyObject* const*, Py_ssize_t,
                                                   PyObject*)) {
  return reinterpret_cast<PyCFunction>(reinterpret_cast<void (*)()>(function));
}

}  // namespace stillpoint::python
