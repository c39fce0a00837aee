// SPDX-License-Identifier: MIT
#include "values.hpp"

#include <stillpoint/records/number.hpp>

#include <cmath>

namespace stillpoint::python {

namespace py = pybind11;
using nlohmann::json;
using nlohmann::ordered_json;

namespace {

json integer(const std::string& field, py::handle value) {
  int overflow = 0;
  const long long whole = PyLong_AsLongLongAndOverflow(value.ptr(), &overflow);
  if (overflow != 0) {
    throw InputError(field, py::str(value).cast<std::string>(),
                     "must be a whole number of at most 18 digits");
  }
  return whole;
}

/// As on the command line, which takes nothing else.
json number(const std::string& field, py::handle value) {
  const double number = PyFloat_AS_DOUBLE(value.ptr());
  return std::isfinite(number) ? number
                               : records::parse_number(field, py::str(value).cast<std::string>());
}

/// A file's name would end at a null character.
json text(const std::string& field, py::handle value) {
  auto bytes = py::reinterpret_borrow<py::object>(value);
  if (PyUnicode_Check(value.ptr())) {
    bytes = py::reinterpret_steal<py::object>(
        PyUnicode_AsEncodedString(value.ptr(), "utf-8", "surrogateescape"));
    if (!bytes) {
      throw py::error_already_set();  // half of a surrogate pair
    }
  }
  auto text = bytes.cast<std::string>();
  if (text.find('\0') != std::string::npos) {
    throw InputError(field, py::repr(value).cast<std::string>(), "must not have a null character");
  }
  return text;
}

/// An array of NumPy, or one of its numbers.
json array(const std::string& field, py::handle value) {
  refuse_masked(field, value);
  const py::object plain = value.attr("tolist")();
  if (!py::type::of(plain).is(py::type::of(value))) {
    return to_json(field, plain);
  }
  // Python has nothing wider than a double, so that a long double is its own plain form.
  if (value.attr("dtype").attr("kind").cast<std::string>() == "f") {
    return to_json(field, py::float_(plain));
  }
  throw InputError(field, py::repr(value).cast<std::string>(), "must be a real number");
}

bool is_list(py::handle value) {
  return PySequence_Check(value.ptr()) != 0 && !PyBytes_Check(value.ptr()) &&
         !PyByteArray_Check(value.ptr());
}

/// Each of them by `to`.
json list(const std::string& field, py::handle values,
          json (*to)(const std::string& field, py::handle value)) {
  json all = json::array();
  for (const py::handle value : values) {
    all.push_back(to(field, value));
  }
  return all;
}

json object(py::handle values) {
  json all = json::object();
  for (const auto& [key, value] : py::dict(py::reinterpret_borrow<py::object>(values))) {
    const auto name = py::str(key).cast<std::string>();
    all[name] = to_json(name, value);
  }
  return all;
}

/// A dict may hold itself.
class Depth {
 public:
  Depth() {
    if (Py_EnterRecursiveCall(" while reading an option") != 0) {
      throw py::error_already_set();
    }
  }
  Depth(const Depth&) = delete;
  Depth& operator=(const Depth&) = delete;
  ~Depth() { Py_LeaveRecursiveCall(); }
};

}  // namespace

void refuse_masked(const std::string& field, py::handle value) {
  if (py::hasattr(value, "mask") &&
      py::module_::import("numpy.ma").attr("is_masked")(value).cast<bool>()) {
    throw InputError(field, py::str(value).cast<std::string>(),
                     "must have no masked entries: fill them or leave them out");
  }
}

json to_json(const std::string& field, py::handle value) {
  const Depth depth;
  const auto has = [value](const char* name) { return py::hasattr(value, name); };
  // A series of pandas has keys as well, but is a list.
  return value.is_none()                   ? json(nullptr)
         : PyBool_Check(value.ptr())       ? json(value.ptr() == Py_True)
         : PyFloat_Check(value.ptr())      ? number(field, value)
         : PyLong_Check(value.ptr())       ? integer(field, value)
         : py::isinstance<py::str>(value)  ? text(field, value)
         : py::isinstance<py::dict>(value) ? object(value)
         : has("__fspath__")               ? to_paths(field, value.attr("__fspath__")())
         : has("tolist")                   ? array(field, value)
         : has("keys")                     ? object(value)
         : is_list(value)                  ? list(field, value, to_json)
                          : throw InputError(field, py::repr(value).cast<std::string>(),
                                             "must be a number, a string or a list of them");
}

json to_paths(const std::string& field, py::handle value) {
  const bool several = py::isinstance<py::list>(value) || py::isinstance<py::tuple>(value);
  return py::isinstance<py::bytes>(value) ? text(field, value)
         : several                        ? list(field, value, to_paths)
                                          : to_json(field, value);
}

std::string to_path(const std::string& field, py::handle value, std::string_view must_be) {
  const json path = to_paths(field, value);
  if (!path.is_string()) {
    throw InputError(field, py::repr(value).cast<std::string>(), std::string(must_be));
  }
  return path.get<std::string>();
}

py::str to_str(std::string_view text) {
  return py::reinterpret_steal<py::str>(
      PyUnicode_DecodeUTF8(text.data(), static_cast<py::ssize_t>(text.size()), "surrogateescape"));
}

py::dict fields() {
  static PyObject* const type =
      py::object(py::module_::import("stillpoint").attr("Fields")).release().ptr();
  return py::reinterpret_steal<py::dict>(PyObject_CallNoArgs(type));
}

py::object to_python(const ordered_json& value) {
  switch (value.type()) {
    case ordered_json::value_t::boolean:
      return py::bool_(value.get<bool>());
    case ordered_json::value_t::number_integer:
      return py::int_(value.get<std::int64_t>());
    case ordered_json::value_t::number_unsigned:
      return py::int_(value.get<std::uint64_t>());
    case ordered_json::value_t::number_float:
      return py::float_(value.get<double>());
    case ordered_json::value_t::string:
      return to_str(value.get_ref<const std::string&>());
    case ordered_json::value_t::array: {
      py::list all;
      for (const ordered_json& entry : value) {
        all.append(to_python(entry));
      }
      return all;
    }
    case ordered_json::value_t::object: {
      py::dict all = fields();
      for (const auto& [key, entry] : value.items()) {
        all[to_str(key)] = to_python(entry);
      }
      return all;
    }
    default:
      return py::none();
  }
}

}  // namespace stillpoint::python
