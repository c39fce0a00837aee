// SPDX-License-Identifier: MIT
#include "held_arrays.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <filesystem>

namespace stillpoint::python {

namespace py = pybind11;
using nlohmann::json;

namespace {

using Doubles = py::array_t<double, py::array::c_style | py::array::forcecast>;

/// Among the entries of a list: NumPy makes numbers of them.
bool has_booleans(const py::object& entries) {
  const py::object boolean = py::module_::import("numpy").attr("bool_");
  return std::any_of(entries.begin(), entries.end(), [&](py::handle entry) {
    return PyBool_Check(entry.ptr()) || py::isinstance(entry, boolean);
  });
}

/// An array, or what NumPy makes one of; float64 arrays in the order of C are not copied. Empty
/// unless all of it are real numbers: booleans are none. Throws InputError that names `field` for
/// masked entries.
std::optional<Doubles> doubles(const std::string& field, py::handle value) {
  refuse_masked(field, value);
  constexpr std::string_view kinds = "iufO";  // integers, floats, Python's own
  const py::array given = py::array::ensure(value);
  if (!given || kinds.find(given.dtype().kind()) == std::string_view::npos) {
    return std::nullopt;
  }
  const bool is_array = py::isinstance<py::array>(value) && given.dtype().kind() != 'O';
  if (!is_array && has_booleans(py::module_::import("numpy")
                                    .attr("array")(value, py::arg("dtype") = "O")
                                    .attr("ravel")())) {
    return std::nullopt;
  }
  auto array = Doubles::ensure(given);
  if (!array) {
    PyErr_Clear();
    return std::nullopt;
  }
  return array;
}

bool is_name(py::handle value) {
  return py::isinstance<py::str>(value) || py::isinstance<py::bytes>(value) ||
         py::hasattr(value, "__fspath__");
}

std::optional<Doubles> column(py::handle value, const std::string& field = "record") {
  auto found = is_name(value) ? std::nullopt : doubles(field, value);
  return found && found->ndim() == 1 ? found : std::nullopt;
}

/// As a file with one or two columns has it, every digit; empty for anything else.
std::string text_of(py::handle value) {
  std::optional<Doubles> times;
  std::optional<Doubles> values = column(value);
  if (!values && !is_name(value) && PySequence_Check(value.ptr()) != 0 && py::len(value) == 2) {
    times = column(value[py::int_(0)]);
    values = times ? column(value[py::int_(1)]) : std::nullopt;
  }
  if (times && values && times->size() != values->size()) {
    throw InputError("record", fmt::format("({} times, {} values)", times->size(), values->size()),
                     "must have a time for each value");
  }
  std::string text;
  for (py::ssize_t i = 0; values && i < values->size(); ++i) {
    text += times ? fmt::format("{} ", times->at(i)) : "";
    text += fmt::format("{}\n", values->at(i));
  }
  return text;
}

/// The names of the columns of a dict, a table of pandas or a structured array; None for anything
/// else.
py::object column_names(py::handle value) {
  if (py::hasattr(value, "keys")) {
    return value.attr("keys")();
  }
  return py::hasattr(value, "dtype") ? py::object(value.attr("dtype").attr("names"))
                                     : py::object(py::none());
}

}  // namespace

std::string HeldArrays::hold(std::string text) {
  if (!files_) {
    files_ = std::make_shared<records::HeldFiles>();
  }
  std::string name = fmt::format("record {}", files_->size() + 1);
  while (std::filesystem::exists(name)) {
    name += '\'';
  }
  files_->emplace(name, std::move(text));
  return name;
}

json HeldArrays::names_in(py::handle value) {
  if (std::string text = text_of(value); !text.empty()) {
    return hold(std::move(text));
  }
  if (is_name(value) || PySequence_Check(value.ptr()) == 0) {
    return to_paths("record", value);
  }
  if (py::isinstance<py::array>(value) && value.attr("ndim").cast<int>() > 1) {
    throw InputError("record",
                     "an array of shape " + py::str(value.attr("shape")).cast<std::string>(),
                     "must be (times, accelerations), or have the shape (2, n)");
  }
  json names = json::array();
  for (const py::handle one : value) {
    std::string text = text_of(one);
    if (text.empty() && PySequence_Check(one.ptr()) != 0 && !is_name(one)) {
      const py::object shown = py::module_::import("reprlib").attr("repr")(one);
      throw InputError("record", shown.cast<std::string>(),
                       "must be a file, an array of numbers, or (times, accelerations)");
    }
    names.push_back(text.empty() ? to_paths("record", one) : json(hold(std::move(text))));
  }
  return names;
}

json HeldArrays::name_of_list(py::handle value) {
  const py::object names = column_names(value);
  if (names.is_none()) {
    return to_paths("list", value);
  }
  sweep::ListColumns columns;
  for (const py::handle key : names) {
    const auto name = py::str(key).cast<std::string>();
    const auto values = column(value[py::reinterpret_borrow<py::object>(key)], name);
    if (!values) {
      throw InputError(name, "a column of the list", "must be an array of numbers");
    }
    columns.emplace_back(name,
                         std::vector<double>(values->data(), values->data() + values->size()));
  }
  list_ = std::make_shared<const sweep::ListColumns>(std::move(columns));
  return "arrays";
}

}  // namespace stillpoint::python
