// SPDX-License-Identifier: MIT
#pragma once

#include <stillpoint/records/file_error.hpp>

#include <nlohmann/json.hpp>

#include <concepts>
#include <cstddef>
#include <cstdint>
#include <iterator>
#include <map>
#include <stdexcept>
#include <string>
#include <string_view>
#include <utility>

namespace stillpoint::sweep {

/// The places of keys; a key of an object within the outermost one is "outer.inner", deeper ones
/// are left out.
using KeyPlaces = std::map<std::string, records::FilePlace>;

/// Throws FileError, with line and column, unless the text is a JSON object, which may have
/// comments, in which no key appears twice, nothing is nested deeper than 16 levels and every
/// number fits a double. With a line in `file`, the text begins there.
KeyPlaces require_json_object(std::string_view text, const records::FilePlace& file);

/// Reads an integer. Throws std::runtime_error for any other value, and for an integer beyond
/// Integer: nlohmann's get_to casts these, which for a double beyond the range is undefined.
template <std::integral Integer>
void read_integers(const nlohmann::ordered_json& value, Integer& to) {
  const bool fits =
      value.is_number_unsigned()
          ? std::in_range<Integer>(value.get<std::uint64_t>())
          : value.is_number_integer() && std::in_range<Integer>(value.get<std::int64_t>());
  if (!fits) {
    throw std::runtime_error("not an integer of that size");
  }
  value.get_to(to);
}

/// The same for each element of a list; an array `to` must have the same length.
template <class List>
requires requires(List& list) {
  std::begin(list);
}
void read_integers(const nlohmann::ordered_json& values, List& to) {
  if (!values.is_array()) {
    throw std::runtime_error("not a list");
  }
  if constexpr (requires { to.resize(values.size()); }) {
    to.resize(values.size());
  }
  if (values.size() != std::size(to)) {
    throw std::runtime_error("not a list of that length");
  }
  for (std::size_t i = 0; i < values.size(); ++i) {
    read_integers(values[i], to[i]);
  }
}

}  // namespace stillpoint::sweep
