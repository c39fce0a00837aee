// SPDX-License-Identifier: MIT
// Free motions of many dampers, from arrays to arrays.

#include "errors.hpp"
#include "interruptible.hpp"
#include "parts.hpp"
#include "values.hpp"

#include <stillpoint/core/batch.hpp>
#include <stillpoint/core/for_each_entry.hpp>
#include <stillpoint/core/free_motion.hpp>
#include <stillpoint/core/input_error.hpp>
#include <stillpoint/sweep/quantity.hpp>

#include <algorithm>
#include <array>
#include <cstdint>
#include <string>
#include <vector>

namespace stillpoint::python {

namespace py = pybind11;

namespace {

using Doubles = py::array_t<double, py::array::c_style | py::array::forcecast>;

/// One damper's four numbers, in the order of the arguments.
enum Place { at_f, at_delta, at_v0, at_p, places };
constexpr std::array<const char*, places> argument_names{"f", "delta", "v0", "p"};
using Arguments = std::array<py::handle, places>;

bool is_number(py::handle value) {
  return PyFloat_Check(value.ptr()) || PyLong_Check(value.ptr());
}

/// The arguments as arrays of one shape; a single number stays one. float64 arrays in the order of
/// C are not copied.
struct Dampers {
  std::array<Doubles, places> arrays;
  std::vector<py::ssize_t> shape;
  py::ssize_t size{1};

  [[nodiscard]] bool single(Place place) const { return arrays[place].ndim() == 0; }
  /// Element i of a single number is that number.
  [[nodiscard]] double at(Place place, py::ssize_t i) const {
    return arrays[place].data()[single(place) ? 0 : i];
  }
};

Doubles as_doubles(py::handle value, const char* name) {
  Doubles array = Doubles::ensure(value);
  if (!array) {
    PyErr_Clear();
    throw ArgumentError(std::string(name) + ": must be a number or an array of numbers");
  }
  return array;
}

Dampers dampers(const Arguments& arguments) {
  Dampers all;
  bool alike = true;
  for (std::size_t i = 0; i < places; ++i) {
    all.arrays[i] = as_doubles(arguments[i], argument_names[i]);
    const std::vector<py::ssize_t> shape(all.arrays[i].shape(),
                                         all.arrays[i].shape() + all.arrays[i].ndim());
    if (!shape.empty() && all.shape.empty()) {
      all.shape = shape;
    }
    alike = alike && (shape.empty() || shape == all.shape);
  }
  if (!alike) {
    const py::list spread = py::module_::import("numpy").attr("broadcast_arrays")(
        all.arrays[at_f], all.arrays[at_delta], all.arrays[at_v0], all.arrays[at_p]);
    for (std::size_t i = 0; i < places; ++i) {
      all.arrays[i] = as_doubles(spread[i], argument_names[i]);
    }
    all.shape.assign(all.arrays[0].shape(), all.arrays[0].shape() + all.arrays[0].ndim());
  }
  for (const py::ssize_t length : all.shape) {
    all.size *= length;
  }
  return all;
}

double peak_of(double f, double delta, double v0, double p) {
  return free_peak({.p = p, .f = f, .delta = delta}, {.x0 = 0, .v0 = v0});
}

/// The loop leaves the arrays in its own blocks: an error names the entry.
Doubles peaks(const Dampers& given, int threads) {
  Doubles found(given.shape);
  double* const peak = found.mutable_data();
  constexpr py::ssize_t block = 4096;
  interruptible([&](const std::stop_token& stop) {
    const auto goes_on = [&] { return !stop.stop_requested(); };
    for_each_entry((given.size + block - 1) / block, threads, goes_on, [&](std::ptrdiff_t piece) {
      const py::ssize_t end = std::min((piece + 1) * block, given.size);
      for (py::ssize_t i = piece * block; i < end; ++i) {
        try {
          peak[i] = peak_of(given.at(at_f, i), given.at(at_delta, i), given.at(at_v0, i),
                            given.at(at_p, i));
        } catch (const InputError& error) {
          throw error.in_entry(i);
        }
      }
    });
  });
  return found;
}

py::object peak(const py::object& f, const py::object& delta, const py::object& v0,
                const py::object& p, int threads) {
  if (is_number(f) && is_number(delta) && is_number(v0) && is_number(p)) {
    return py::float_(peak_of(f.cast<double>(), delta.cast<double>(), v0.cast<double>(),
                              p.cast<double>()));
  }
  const Dampers given = dampers({f, delta, v0, p});
  return peaks(given, threads);
}

}  // namespace

void add_arrays(py::module_& module) {
  module.def("peak", &peak, py::arg("f"), py::arg("delta"), py::arg("v0"), py::arg("p"),
             py::kw_only(), py::arg("threads") = 0);
}

}  // namespace stillpoint::python
