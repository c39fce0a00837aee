// SPDX-License-Identifier: MIT
#pragma once

#include <pybind11/numpy.h>
#include <nlohmann/json.hpp>

#include <memory>
#include <string>
#include <utility>
#include <vector>

namespace stillpoint::python {

/// A value of an option: None, a bool, a number, a string, a path, a sequence, a mapping, or
/// NumPy's versions of these. Throws InputError that names `field` for anything else.
[[nodiscard]] nlohmann::json to_json(const std::string& field, pybind11::handle value);

/// A str, or a path of the library. Throws InputError that names `field` for anything else.
[[nodiscard]] std::string to_path(const std::string& field, pybind11::handle value);

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
