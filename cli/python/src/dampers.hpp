// SPDX-License-Identifier: MIT
#pragma once

#include "numbers.hpp"

#include <stillpoint/core/for_each_entry.hpp>

#include <pybind11/numpy.h>
#include <pybind11/pybind11.h>

#include <array>
#include <vector>

namespace stillpoint::python {

namespace py = pybind11;

/// One damper's four numbers, in the order of the arguments.
enum Place { at_f, at_delta, at_v0, at_p, places };
using Arguments = std::array<py::handle, places>;

/// The arguments as arrays of one shape; a single number stays one. float64 arrays in the order of
/// C are not copied.
struct Dampers {
  std::array<Doubles, places> arrays;
  std::vector<py::ssize_t> shape;
  py::ssize_t size{1};

  [[nodiscard]] bool single(Place place) const { return arrays[place].ndim() == 0; }
  /// Makes an array of a single number.
  void spread(Place place);
};

/// 0 in Python stands for all threads.
[[nodiscard]] inline Threads threads_of(int given) {
  return given == 0 ? Threads() : Threads(given);
}

/// Throws ArgumentError for what are no numbers, and for shapes that do not go together.
[[nodiscard]] Dampers dampers(const Arguments& arguments);

}  // namespace stillpoint::python
