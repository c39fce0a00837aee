// SPDX-License-Identifier: MIT
#include "messages.hpp"
#include "options/settings.hpp"
#include "parts.hpp"
#include "values.hpp"

#include <stillpoint/core/for_each_entry.hpp>
#include <stillpoint/report/document.hpp>
#include <stillpoint/report/page_frame.hpp>

#include <system_error>

namespace stillpoint::python {

namespace py = pybind11;

namespace {

PyObject* input_error = nullptr;

void refuse(const std::exception& error) {
  PyErr_SetObject(input_error, to_str(report::spelled_out(error.what())).ptr());
}

/// stillpoint.InputError, a ValueError, with the text that the program prints, for any wrong input.
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

}  // namespace

}  // namespace stillpoint::python

PYBIND11_MODULE(_stillpoint, module) {
  stillpoint::cli::open_closed_streams();
  module.attr("__version__") = stillpoint::report::program_version();
  pybind11::options signatures;
  signatures.disable_function_signatures();  // each text begins with its own
  stillpoint::python::add_errors(module);
  stillpoint::python::add_result(module);
  stillpoint::python::add_commands(module);
  stillpoint::python::add_sweep(module);
  stillpoint::python::add_records(module);
}
