// SPDX-License-Identifier: MIT
#include "numbers.hpp"

#include <stillpoint/core/input_error.hpp>

#include <algorithm>
#include <string_view>

namespace stillpoint::python {

namespace py = pybind11;

namespace {

/// Among the entries of a list: NumPy makes numbers of them.
bool has_booleans(const py::object& entries) {
  const py::object boolean = py::module_::import("numpy").attr("bool_");
  return std::any_of(entries.begin(), entries.end(), [&](py::handle entry) {
    return PyBool_Check(entry.ptr()) || py::isinstance(entry, boolean);
  });
}

}  // namespace

void refuse_masked(const std::string& field, py::handle value) {
  if (py::hasattr(value, "mask") &&
      py::module_::import("numpy.ma").attr("is_masked")(value).cast<bool>()) {
    throw InputError(field, py::str(value).cast<std::string>(),
                     "must have no masked entries: fill them or leave them out");
  }
}

std::optional<Doubles> doubles(const std::string& field, py::handle value) {
  refuse_masked(field, value);
  constexpr std::string_view kinds = "iufO";  // integers, floats, Python's own
  const py::array given = py::array::ensure(value);
  if (!given || kinds.find(given.dtype().kind()) == std::string_view::npos) {
    return std::nullopt;
  }
  const bool is_array = py::isinstance<py::array>(value) && given.dtype().kind() != 'O';
  if (!is_array && has_booleans(py::module_::import("numpy")
                                    .attr("array")(value, py::arg("dtype") = "O")
                                    .attr("ravel")())) {
    return std::nullopt;
  }
  auto array = Doubles::ensure(given);
  if (!array) {
    PyErr_Clear();
    return std::nullopt;
  }
  return array;
}

}  // namespace stillpoint::python
