// SPDX-License-Identifier: MIT
#include "errors.hpp"

#include "messages.hpp"
#include "options/settings.hpp"
#include "values.hpp"

#include <stillpoint/core/for_each_entry.hpp>
#include <stillpoint/core/input_error.hpp>
#include <stillpoint/records/file_error.hpp>
#include <stillpoint/report/document.hpp>

#include <exception>
#include <system_error>
#include <utility>

namespace stillpoint::python {

namespace py = pybind11;

namespace {

PyObject* input_error = nullptr;

/// Such an error is an InputError in Python.
template <class Error>
void refuse() {
  py::register_exception_translator([](std::exception_ptr thrown) {
    try {
      std::rethrow_exception(std::move(thrown));
    } catch (const Error& error) {
      PyErr_SetObject(input_error, to_str(report::spelled_out(error.what())).ptr());
    }
  });
}

}  // namespace

void add_errors(py::module_& module) {
  input_error = PyErr_NewExceptionWithDoc(
      "stillpoint.InputError",
      "The input is wrong. The text names the field, the value and the bound, as the program does.",
      PyExc_ValueError, nullptr);
  module.add_object("InputError", input_error);
  refuse<InputError>();
  refuse<ArgumentError>();
  refuse<EntryError>();
  refuse<TooManyHalfCycles>();
  refuse<cli::UsageError>();
  refuse<records::FileError>();
  py::register_exception_translator([](std::exception_ptr thrown) {
    try {
      std::rethrow_exception(std::move(thrown));
    } catch (const std::system_error& error) {
      PyErr_SetString(PyExc_RuntimeError, cli::words_of(error).c_str());
    }
  });
}

}  // namespace stillpoint::python
