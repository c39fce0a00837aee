// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <cassert>
#include <optional>
#include <span>
#include <string_view>
#include <type_traits>
#include <utility>
#include <vector>

namespace stillpoint {

template <class Enum>
using Named = std::pair<Enum, std::string_view>;

/// An enum with the table of its names beside it; the argument only selects the enum:
///   std::span<const Named<Side>> enumerators(Side) noexcept;
template <class Enum>
concept HasNames = std::is_enum_v<Enum> && requires(Enum value) {
  { enumerators(value) } -> std::same_as<std::span<const Named<Enum>>>;
};

/// The name of an enumerator in options and reports.
template <HasNames Enum>
[[nodiscard]] std::string_view name(Enum value) noexcept {
  const auto rows = enumerators(value);
  const auto row = std::ranges::find(rows, value, &Named<Enum>::first);
  assert(row != rows.end() && "an enumerator without a name");
  return row->second;
}

/// The enumerator of that name; empty where there is none.
template <HasNames Enum>
[[nodiscard]] std::optional<Enum> parse(std::string_view name) noexcept {
  const auto rows = enumerators(Enum{});
  const auto row = std::ranges::find(rows, name, &Named<Enum>::second);
  return row != rows.end() ? std::optional(row->first) : std::nullopt;
}

/// All names, in the order of the table.
template <HasNames Enum>
[[nodiscard]] std::vector<std::string_view> names() {
  std::vector<std::string_view> list;
  for (const auto& [value, name] : enumerators(Enum{})) {
    list.push_back(name);
  }
  return list;
}

}  // namespace stillpoint
