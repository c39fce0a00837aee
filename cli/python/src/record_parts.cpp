// SPDX-License-Identifier: MIT
// Designs under records in parts: what is one, and what all of them make.

#include "record_parts.hpp"

#include "input/request.hpp"
#include "interruptible.hpp"
#include "output.hpp"
#include "parts.hpp"
#include "values.hpp"
#include "written_files.hpp"

#include <stillpoint/core/input_error.hpp>

#include <string>
#include <vector>

namespace stillpoint::python {

namespace py = pybind11;
using cli::Command;

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

std::unique_ptr<Result> merge(const py::object& parts) {
  const std::vector<std::string> files = paths(parts);
  return std::make_unique<Result>(interruptible([&](const std::stop_token& stop) {
    const report::RecordScan scan = report::merged_record_scan(files);
    const report::RecordDesignInput input =
        record_design_input(cli::record_design_settings(scan.label.task), scan);
    return answers::answer_of(report::RecordDesignReport{
        design::design(input.request, scan.figures,
                       [&](const auto& /*progress*/) { return !stop.stop_requested(); }),
        input.physical});
  }));
}

}  // namespace

std::unique_ptr<Result> design_part(cli::Settings settings) {
  cli::resolve_part(settings);
  cli::require_files_apart(Command::design, settings, std::nullopt);
  const auto found = interruptible([&](const std::stop_token& stop) {
    const report::RecordDesignInput input = cli::record_design_input(settings);
    return report::record_part(cli::record_part_label(settings, input.request), input.request,
                               settings.flag("resume"),
                               [&](const auto& /*progress*/) { return !stop.stop_requested(); });
  });
  cli::Output output;
  write(*found, output);
  output.commit();
  return std::make_unique<Result>(answers::answer_of(found->scan));
}

void add_record_parts(py::module_& module) {
  module.def("merge", &merge, py::arg("parts"),
             R"(merge(parts)
--

The design under records that design(part=..., output=...) has computed in parts, and the searches
that need all of them: what design finds in one run.

parts  paths of all its files, in any order

Raises InputError if a part is missing, double, cut short or of another design, or if the records
have changed.)");
}

}  // namespace stillpoint::python
