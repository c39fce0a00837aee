// SPDX-License-Identifier: MIT
#pragma once

#include <pybind11/pybind11.h>

namespace stillpoint::python {

/// stillpoint.InputError, a ValueError, with the text that the program prints, for any wrong input.
void add_errors(pybind11::module_& module);

/// An error that only a Python argument can have.
class ArgumentError : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

}  // namespace stillpoint::python
