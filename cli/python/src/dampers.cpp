// SPDX-License-Identifier: MIT
#include "dampers.hpp"

#include "errors.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <utility>

namespace stillpoint::python {

namespace {

constexpr std::array<const char*, places> argument_names{"f", "delta", "v0", "p"};

Doubles as_doubles(py::handle value, const char* name) {
  if (auto array = doubles(name, value)) {
    return *std::move(array);
  }
  throw ArgumentError(fmt::format("{}: must be a number or an array of numbers", name));
}

std::vector<py::ssize_t> shape_of(const py::array& array) {
  return {array.shape(), array.shape() + array.ndim()};
}

void broadcast(Dampers& all) {
  py::list spread;
  try {
    spread = py::module_::import("numpy").attr("broadcast_arrays")(
        all.arrays[at_f], all.arrays[at_delta], all.arrays[at_v0], all.arrays[at_p]);
  } catch (const py::error_already_set&) {
    throw ArgumentError("f, delta, v0, p: must have one shape, or shapes that NumPy broadcasts");
  }
  for (std::size_t i = 0; i < places; ++i) {
    all.arrays[i] = as_doubles(spread[i], argument_names[i]);
  }
  all.shape = shape_of(all.arrays[at_f]);
}

}  // namespace

void Dampers::spread(Place place) {
  if (single(place)) {
    const double value = *arrays[place].data();
    arrays[place] = Doubles(shape);
    std::fill_n(arrays[place].mutable_data(), size, value);
  }
}

Dampers dampers(const Arguments& arguments) {
  Dampers all;
  bool alike = true;
  for (std::size_t i = 0; i < places; ++i) {
    all.arrays[i] = as_doubles(arguments[i], argument_names[i]);
    const std::vector<py::ssize_t> shape = shape_of(all.arrays[i]);
    if (all.shape.empty()) {
      all.shape = shape;
    }
    alike = alike && (shape.empty() || shape == all.shape);
  }
  if (!alike) {
    broadcast(all);
  }
  for (const py::ssize_t length : all.shape) {
    all.size *= length;
  }
  return all;
}

}  // namespace stillpoint::python
