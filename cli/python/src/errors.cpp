// SPDX-License-Identifier: MIT
#include "errors.hpp"

#include "options/settings.hpp"

#include <stillpoint/core/for_each_entry.hpp>
#include <stillpoint/core/input_error.hpp>
#include <stillpoint/records/file_error.hpp>
#include <stillpoint/report/document.hpp>
#include <stillpoint/sweep/sink.hpp>

#include <exception>
#include <utility>

namespace stillpoint::python {

namespace py = pybind11;

namespace {

PyObject* input_error = nullptr;

void refuse(const std::exception& error) {
  PyErr_SetString(input_error, report::spelled_out(error.what()).c_str());
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
    } catch (const ArgumentError& error) {
      refuse(error);
    } catch (const EntryError& error) {
      refuse(error);
    } catch (const TooManyHalfCycles& error) {
      refuse(error);
    } catch (const cli::UsageError& error) {
      refuse(error);
    } catch (const records::FileError& error) {
      refuse(error);
    } catch (const sweep::LeftoverError& error) {
      refuse(error);
    }
  });
}

}  // namespace stillpoint::python
