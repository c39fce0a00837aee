// SPDX-License-Identifier: MIT
#include "messages.hpp"
#include "options/settings.hpp"
#include "parts.hpp"
#include "values.hpp"

#include <stillpoint/core/for_each_entry.hpp>
#include <stillpoint/records/file_error.hpp>
#include <stillpoint/report/document.hpp>

#include <system_error>

namespace stillpoint::python {

namespace py = pybind11;

namespace {

PyObject* input_error = nullptr;

void refuse(const std::exception& error) {
  PyErr_SetObject(input_error, to_str(report::spelled_out(error.what())).ptr());
}

}  // namespace

void add_errors(py::module_& module) {
  input_error = PyErr_NewExceptionWithDoc(
      "stillpoint.InputError",
      "The input is wrong. The text names the field, the value and the bound, as the program does.",
      PyExc_ValueError, nullptr);
  module.add_object("InputError", input_error);
  py::register_exception_translator([](std::exception_ptr thrown) {
    try {
      std::rethrow_exception(std::move(thrown));
    } catch (const InputError& error) {
      refuse(error);
    } catch (const EntryError& error) {
      refuse(error);
    } catch (const TooManyHalfCycles& error) {
      refuse(error);
    } catch (const cli::UsageError& error) {
      refuse(error);
    } catch (const records::FileError& error) {
      refuse(error);
    } catch (const std::system_error& error) {
      PyErr_SetString(PyExc_RuntimeError, cli::words_of(error).c_str());
    }
  });
}

}  // namespace stillpoint::python
