// SPDX-License-Identifier: MIT
#include "errors.hpp"
#include "parts.hpp"
#include "result.hpp"

#include <stillpoint/report/version.hpp>

PYBIND11_MODULE(_stillpoint, module) {
  using namespace stillpoint::python;
  module.attr("__version__") = stillpoint::report::program_version();
  pybind11::options signatures;
  signatures.disable_function_signatures();  // each text begins with its own
  add_errors(module);
  add_result(module);
  add_commands(module);
  add_sweep(module);
  add_arrays(module);
  add_records(module);
}
