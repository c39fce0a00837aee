// SPDX-License-Identifier: MIT
// What all parts of a sweep make.

#include "output.hpp"
#include "parts.hpp"
#include "sweep_rows.hpp"
#include "values.hpp"

#include <stillpoint/core/input_error.hpp>
#include <stillpoint/report/reduction.hpp>
#include <stillpoint/sweep/merge.hpp>

#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace stillpoint::python {

namespace py = pybind11;

namespace {

/// A single one may be given without a list.
std::vector<std::string> paths(const py::object& given) {
  if (!py::isinstance<py::list>(given) && !py::isinstance<py::tuple>(given)) {
    return {to_path("parts", given)};
  }
  std::vector<std::string> paths;
  for (const py::handle path : given) {
    paths.push_back(to_path("parts", path));
  }
  if (paths.empty()) {
    throw InputError("parts", "[]", "must have a path");
  }
  return paths;
}

/// Where it was asked for, as the program writes it.
py::object written(std::unique_ptr<Sweep> found, const std::optional<std::string>& path) {
  if (path) {
    cli::Output output;
    output.write_file("output", *path, report::json_text(found->answer().json()));
    output.commit();
  }
  return py::cast(std::move(found));
}

py::object merge(const py::object& parts, const py::object& output) {
  const std::vector<std::string> files = paths(parts);
  const auto to = output.is_none() ? std::nullopt : std::optional(to_path("output", output));
  if (to) {
    sweep::require_apart({"output", *to}, files);
  }
  if (report::is_reduction(files.front())) {
    return written(merged_reduction(files), to);
  }
  return py::cast(merged_rows(files, to));
}

}  // namespace

void add_merge(py::module_& module) {
  module.def("merge", &merge, py::arg("parts"), py::kw_only(), py::arg("output") = py::none(),
             R"(merge(parts, *, output=None)
--

Joins the parts that sweep(part=..., output=...) made, on any machine, into the result of one run. A
reduced sweep gives the report of the whole; any other sweep has its rows as table.

parts   paths of all the parts, in any order
output  a file for the rows, or the report; without it rows must be in NumPy's format

Raises InputError for a part that is missing, given twice, cut short or of another run.)");
}

}  // namespace stillpoint::python
