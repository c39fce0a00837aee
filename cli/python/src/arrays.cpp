// SPDX-License-Identifier: MIT
// Free motions of many dampers, from arrays to arrays.

#include "errors.hpp"
#include "interruptible.hpp"
#include "method.hpp"
#include "parts.hpp"
#include "values.hpp"

#include <stillpoint/core/batch.hpp>
#include <stillpoint/core/for_each_entry.hpp>
#include <stillpoint/core/free_motion.hpp>
#include <stillpoint/core/input_error.hpp>
#include <stillpoint/sweep/quantity.hpp>

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

namespace stillpoint::python {

namespace py = pybind11;

namespace {

using Doubles = py::array_t<double, py::array::c_style | py::array::forcecast>;

/// One damper's four numbers, in the order of the arguments.
enum Place { at_f, at_delta, at_v0, at_p, places };
constexpr std::array<const char*, places> argument_names{"f", "delta", "v0", "p"};
using Arguments = std::array<py::handle, places>;

constexpr const char* peak_doc = R"(peak(f, delta, v0, p, *, threads=0)
--

The largest |x| of the free motion from x = 0, dimensionless, in constant time.

f, delta, v0, p  numbers or float64 arrays that broadcast together; arrays in C order are not copied
threads          of an array; 0: one per hardware thread

Returns a float, or an array of the common shape. Raises InputError, which names a wrong entry.)";

constexpr const char* motions_doc =
    R"(motions(f, delta, v0, p, *, times=False, acceleration=False, half_cycle_limit=1e8, threads=0)
--

The free motions from x = 0 of many dampers, dimensionless.

f, delta, v0, p   numbers or float64 arrays that broadcast together; arrays in C order are not copied
times             stop_time as well
acceleration      peak_absolute_acceleration as well
half_cycle_limit  refuse a motion that may have more half-cycles
threads           0: one per hardware thread; no result depends on it

Returns Fields of arrays of the common shape: peak_amplitude, half_cycles, outcome (the index in
stillpoint.outcomes, uint8), stop_position. Where a motion never stops, half_cycles and stop_time
are infinite and stop_position is 0. Raises InputError, which names a wrong entry.)";

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
  /// Makes an array of a single number.
  void spread(Place place) {
    if (single(place)) {
      const double value = *arrays[place].data();
      arrays[place] = Doubles(shape);
      std::fill_n(arrays[place].mutable_data(), size, value);
    }
  }
};

/// Element i of an array; of a single number always that.
class Values {
 public:
  explicit Values(const Dampers& given, Place place)
      : data_(given.arrays[place].data()), stride_(given.single(place) ? 0 : 1) {}
  double operator[](py::ssize_t i) const { return data_[i * stride_]; }

 private:
  const double* data_;
  py::ssize_t stride_;
};

Doubles as_doubles(py::handle value, const char* name) {
  constexpr std::string_view kinds = "biufO";  // bools, integers, floats, Python's own
  const py::array given = py::array::ensure(value);
  const bool numbers = given && kinds.find(given.dtype().kind()) != std::string_view::npos;
  auto array = py::reinterpret_steal<Doubles>(py::handle());
  if (numbers) {
    array = Doubles::ensure(given);
  }
  if (!array) {
    PyErr_Clear();
    throw ArgumentError(fmt::format("{}: must be a number or an array of numbers", name));
  }
  return array;
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

double peak_of(double f, double delta, double v0, double p) {
  return free_peak({.p = p, .f = f, .delta = delta}, {.x0 = 0, .v0 = v0});
}

Doubles peaks(const Dampers& given, int threads) {
  Doubles found(given.shape);
  double* const peak = found.mutable_data();
  const Values f(given, at_f);
  const Values delta(given, at_delta);
  const Values v0(given, at_v0);
  const Values p(given, at_p);
  const auto run = [&](py::ssize_t i, py::ssize_t end) {
    try {
      for (; i < end; ++i) {
        peak[i] = peak_of(f[i], delta[i], v0[i], p[i]);
      }
    } catch (const InputError& error) {
      throw error.in_entry(i);
    }
  };
  constexpr py::ssize_t block = 4096;  // about 0.1 ms, not worth a thread
  if (given.size <= block) {
    const py::gil_scoped_release released;
    run(0, given.size);
    return found;
  }
  interruptible([&](const std::stop_token& stop) {
    const auto goes_on = [&] { return !stop.stop_requested(); };
    for_each_entry((given.size + block - 1) / block, threads, goes_on, [&](std::ptrdiff_t piece) {
      run(piece * block, std::min((piece + 1) * block, given.size));
    });
  });
  return found;
}

py::object peak(const py::object& f, const py::object& delta, const py::object& v0,
                const py::object& p, int threads) {
  if (is_number(f) && is_number(delta) && is_number(v0) && is_number(p)) {
    return py::float_(
        peak_of(f.cast<double>(), delta.cast<double>(), v0.cast<double>(), p.cast<double>()));
  }
  const Dampers given = dampers({f, delta, v0, p});
  return peaks(given, threads);
}

using Block = Eigen::Map<const Eigen::ArrayXd>;

/// free_batch of the entries from `begin` to `end`. Uses the overload for a single v0 and p if it
/// can.
void run_block(const Dampers& given, py::ssize_t begin, py::ssize_t end,
               const BatchOptions& options, BatchResult& result) {
  const auto part = [&](Place place) {
    return Block(given.arrays[place].data() + begin, end - begin);
  };
  if (given.single(at_v0) && given.single(at_p)) {
    free_batch(*given.arrays[at_v0].data(), *given.arrays[at_p].data(), part(at_f), part(at_delta),
               options, result);
  } else {
    free_batch(part(at_v0), part(at_p), part(at_f), part(at_delta), options, result);
  }
}

/// A result of all blocks, and the memory of its array, which is found with the interpreter's lock.
struct Column {
  const char* name;
  Eigen::ArrayXd BatchResult::*values;
  Doubles array;
  double* memory{array.mutable_data()};
};

/// In blocks, so that an interrupt is seen between two of them.
void run_all(const Dampers& given, const BatchOptions& options, const std::vector<Column>& columns,
             std::uint8_t* outcomes, const std::stop_token& stop) {
  constexpr py::ssize_t block = 262'144;
  BatchResult result;
  for (py::ssize_t begin = 0; begin < given.size && !stop.stop_requested(); begin += block) {
    const py::ssize_t end = std::min(begin + block, given.size);
    try {
      run_block(given, begin, end, options, result);
    } catch (const std::exception&) {
      run_block(given, 0, end, options, result);  // throws again, with the entry of the whole
    }
    for (const Column& column : columns) {
      const Eigen::ArrayXd& values = result.*column.values;
      std::copy_n(values.data(), values.size(), column.memory + begin);
    }
    std::transform(
        result.outcome.data(), result.outcome.data() + result.outcome.size(), outcomes + begin,
        [](Outcome outcome) { return static_cast<std::uint8_t>(sweep::sweep_outcome(outcome)); });
  }
}

py::dict motions(const py::object& f, const py::object& delta, const py::object& v0,
                 const py::object& p, bool times, bool acceleration, double half_cycle_limit,
                 int threads) {
  Dampers given = dampers({f, delta, v0, p});
  given.spread(at_f);
  given.spread(at_delta);
  if (!given.single(at_v0) || !given.single(at_p)) {
    given.spread(at_v0);
    given.spread(at_p);
  }
  BatchOptions options;
  options.times = times;
  options.acceleration = acceleration;
  options.half_cycle_limit = half_cycle_limit;
  options.threads = threads;
  const auto column = [&given](const char* name, Eigen::ArrayXd BatchResult::*values) {
    return Column{name, values, Doubles(given.shape)};
  };
  std::vector<Column> columns{column("peak_amplitude", &BatchResult::peak_amplitude),
                              column("half_cycles", &BatchResult::half_cycles),
                              column("stop_position", &BatchResult::stop_position)};
  if (times) {
    columns.push_back(column("stop_time", &BatchResult::stop_time));
  }
  if (acceleration) {
    columns.push_back(
        column("peak_absolute_acceleration", &BatchResult::peak_absolute_acceleration));
  }
  py::array_t<std::uint8_t> outcome(given.shape);
  interruptible([&, outcomes = outcome.mutable_data()](const std::stop_token& stop) {
    run_all(given, options, columns, outcomes, stop);
  });
  py::dict all = fields();
  for (const Column& now : columns) {
    all[now.name] = now.array;
    if (now.values == &BatchResult::half_cycles) {
      all["outcome"] = outcome;
    }
  }
  return all;
}

/// peak(f, delta, v0, p) of four floats, without the conversions of pybind11: half a microsecond
/// less. Anything else goes to the general function.
PyObject* general_peak = nullptr;

PyObject* fast_peak(PyObject* /*module*/, PyObject* const* values, Py_ssize_t count,
                    PyObject* names) {
  const auto is_float = [](PyObject* value) { return PyFloat_CheckExact(value) != 0; };
  if (count == places && names == nullptr && std::all_of(values, values + count, is_float)) {
    try {
      return PyFloat_FromDouble(
          peak_of(PyFloat_AS_DOUBLE(values[at_f]), PyFloat_AS_DOUBLE(values[at_delta]),
                  PyFloat_AS_DOUBLE(values[at_v0]), PyFloat_AS_DOUBLE(values[at_p])));
    } catch (const std::exception&) {
      // which the general function throws again
    }
  }
  return PyObject_Vectorcall(general_peak, values, static_cast<std::size_t>(count), names);
}

}  // namespace

void add_arrays(py::module_& module) {
  const py::cpp_function general(&peak, py::name("peak"), py::arg("f"), py::arg("delta"),
                                 py::arg("v0"), py::arg("p"), py::kw_only(),
                                 py::arg("threads") = 0);
  general_peak = general.inc_ref().ptr();
  static std::array<PyMethodDef, 2> methods{
      {{"peak", as_method(&fast_peak), METH_FASTCALL | METH_KEYWORDS, peak_doc}, {}}};
  PyModule_AddFunctions(module.ptr(), methods.data());
  py::list names;
  for (std::size_t i = 0; i < sweep::sweep_outcome_count; ++i) {
    names.append(py::str(std::string(sweep::sweep_outcome_name(i))));
  }
  module.attr("outcomes") = py::tuple(names);
  module.def("motions", &motions, py::arg("f"), py::arg("delta"), py::arg("v0"), py::arg("p"),
             py::kw_only(), py::arg("times") = false, py::arg("acceleration") = false,
             py::arg("half_cycle_limit") = BatchOptions().half_cycle_limit, py::arg("threads") = 0,
             motions_doc);
}

}  // namespace stillpoint::python
