// SPDX-License-Identifier: MIT
#pragma once

// The files of the module do not list again the headers that this one brings.

#include <stillpoint/core/input_error.hpp>

#include <pybind11/numpy.h>
#include <nlohmann/json.hpp>

#include <memory>
#include <optional>

namespace stillpoint::python {

/// A value of an option: None, a bool, a number, a string, a path, a sequence, a mapping, or
/// NumPy's versions of these. The bytes of names that are not UTF-8 stay as they are. Throws
/// InputError that names `field` for anything else, and for masked entries.
[[nodiscard]] nlohmann::json to_json(const std::string& field, pybind11::handle value);

/// Throws that InputError for a value with masked entries: what is behind a mask is not meant.
void refuse_masked(const std::string& field, pybind11::handle value);

/// The same of an option that names files: bytes are paths as well.
[[nodiscard]] nlohmann::json to_paths(const std::string& field, pybind11::handle value);

/// A str, bytes, or a path of the library. Throws InputError that names `field` for anything else.
[[nodiscard]] std::string to_path(const std::string& field, pybind11::handle value,
                                  std::string_view must_be = "must be a path");

/// Text in which bytes that are not UTF-8 are what os.fsencode turns back into them.
[[nodiscard]] pybind11::str to_str(std::string_view text);

/// Objects become stillpoint.Fields.
[[nodiscard]] pybind11::object to_python(const nlohmann::ordered_json& value);

/// An empty stillpoint.Fields.
[[nodiscard]] pybind11::dict fields();

/// Keeps `owner` for as long as an array needs it.
template <class Owner>
pybind11::capsule kept(std::unique_ptr<Owner> owner) {
  return {owner.release(), [](void* kept) { delete static_cast<Owner*>(kept); }};
}

/// The same memory as a NumPy array that owns it.
template <class Element>
pybind11::array to_array(std::vector<Element> values) {
  auto owner = std::make_unique<std::vector<Element>>(std::move(values));
  const auto size = static_cast<pybind11::ssize_t>(owner->size());
  const Element* const data = owner->data();
  return pybind11::array_t<Element>(size, data, kept(std::move(owner)));
}

}  // namespace stillpoint::python
