// SPDX-License-Identifier: MIT
#pragma once

#include <pybind11/pybind11.h>

namespace stillpoint::python {

/// stillpoint.InputError, a ValueError, with the text that the program prints: of whatever is wrong
/// with the input.
void add_errors(pybind11::module_& module);

/// An argument that Python alone can get wrong.
class ArgumentError : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

}  // namespace stillpoint::python
