// SPDX-License-Identifier: MIT
#pragma once

#include <pybind11/numpy.h>

#include <optional>
#include <string>

namespace stillpoint::python {

using Doubles = pybind11::array_t<double, pybind11::array::c_style | pybind11::array::forcecast>;

/// An array, or what NumPy makes one of; float64 arrays in the order of C are not copied. Empty
/// unless all of it are real numbers: booleans are none. Throws InputError that names `field` for
/// masked entries.
[[nodiscard]] std::optional<Doubles> doubles(const std::string& field, pybind11::handle value);

/// Throws that InputError: what is behind a mask is not meant.
void refuse_masked(const std::string& field, pybind11::handle value);

}  // namespace stillpoint::python
