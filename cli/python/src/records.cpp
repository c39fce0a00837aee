// SPDX-License-Identifier: MIT
#include "held_arrays.hpp"
#include "parts.hpp"

#include <stillpoint/records/text.hpp>

#include <pybind11/stl.h>

namespace stillpoint::python {

namespace py = pybind11;

namespace {

/// Evenly spaced times are made here: a file has only their step.
std::vector<double> times_of(const Record& record) {
  std::vector<double> times(record.values.size());
  for (std::size_t i = 0; i < times.size(); ++i) {
    times[i] = static_cast<double>(i) * record.step;
  }
  return times;
}

py::dict read_record(const py::object& record, const std::optional<std::string>& units,
                     const std::optional<double>& step, double scale, double gravity) {
  records::RecordOptions options;
  options.step = step;
  if (units) {
    options.units = parse<records::RecordUnits>(*units);
    if (!options.units) {
      throw InputError("record-units", *units,
                       records::must_be(*units, names<records::RecordUnits>()));
    }
  }
  options.scale = scale;
  options.gravity_m_per_s2 = gravity;
  HeldArrays arrays;
  const nlohmann::json named = arrays.names_in(record);
  const std::string path = named.is_string() ? named.get<std::string>() : to_path("record", record);
  options.held = arrays.files();
  records::RecordFile file = [&] {
    const py::gil_scoped_release released;
    return records::read_record(path, options);
  }();
  py::dict found = fields();
  found["file"] = to_str(path);
  found["description"] = file.description;
  found["units"] = py::str(std::string(name(file.units)));
  found["step"] = file.record.times.empty() ? py::object(py::float_(file.record.step)) : py::none();
  found["times"] =
      to_array(file.record.times.empty() ? times_of(file.record) : std::move(file.record.times));
  found["accelerations"] = to_array(std::move(file.record.values));
  return found;
}

}  // namespace

void add_records(py::module_& module) {
  module.def(
      "read_record", &read_record, py::arg("record"), py::kw_only(),
      py::arg("record_units") = py::none(), py::arg("record_step") = py::none(),
      py::arg("record_scale") = 1.0, py::arg("gravity") = 9.80665,
      R"(read_record(record, *, record_units=None, record_step=None, record_scale=1, gravity=9.80665)
--

An acceleration record from a file, in any format that the program reads, or from arrays.

record        path of the file; or (times, accelerations), or accelerations with record_step
record_units  of its values, "g", "m/s2" or "cm/s2"; default: as the file says, else g
record_step   time between two values in s, for a file without times
record_scale  factor on every value
gravity       m/s2, one g

Returns Fields: file, description and units of the file as given, step in s (None where the
file has times), times in s and
accelerations in g, both float64 arrays of shape (n,).)");
}

}  // namespace stillpoint::python
