// SPDX-License-Identifier: MIT
// The peaks of free motions, of single dampers and of arrays.

#include "dampers.hpp"
#include "interruptible.hpp"
#include "parts.hpp"

#include <stillpoint/core/for_each_entry.hpp>
#include <stillpoint/core/free_motion.hpp>
#include <stillpoint/core/input_error.hpp>

#include <algorithm>
#include <array>

namespace stillpoint::python {

namespace {

constexpr const char* peak_doc = R"(peak(f, delta, v0, p, *, threads=0)
--

The largest |x| of the free motion from x = 0, dimensionless, in constant time.

f, delta, v0, p  numbers or float64 arrays that broadcast together; arrays in C order are not copied
threads          for arrays; 0: one per hardware thread

Returns a float, or an array of the common shape. Raises InputError, which names the wrong entry.)";

bool is_number(py::handle value) {
  return PyFloat_Check(value.ptr()) || PyLong_Check(value.ptr());
}

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

double peak_of(double f, double delta, double v0, double p) {
  return free_peak({.p = p, .f = f, .delta = delta}, {.x0 = 0, .v0 = v0});
}

Doubles peaks(const Dampers& given, const Threads& threads) {
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
  return peaks(given, threads_of(threads));
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

void add_peak(py::module_& module) {
  const py::cpp_function general(&peak, py::name("peak"), py::arg("f"), py::arg("delta"),
                                 py::arg("v0"), py::arg("p"), py::kw_only(),
                                 py::arg("threads") = 0);
  general_peak = general.inc_ref().ptr();
  static std::array<PyMethodDef, 2> methods{
      {{"peak", as_method(&fast_peak), METH_FASTCALL | METH_KEYWORDS, peak_doc}, {}}};
  PyModule_AddFunctions(module.ptr(), methods.data());
}

}  // namespace stillpoint::python
