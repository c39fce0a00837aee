// SPDX-License-Identifier: MIT
#include "parts.hpp"
#include "standard_streams.hpp"

#include <stillpoint/report/page_frame.hpp>

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
