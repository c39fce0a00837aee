// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <array>
#include <cassert>
#include <cstddef>
#include <optional>
#include <span>
#include <string_view>
#include <type_traits>
#include <utility>
#include <vector>

namespace stillpoint {

template <class Enum>
using Named = std::pair<Enum, std::string_view>;

/// An enumerator as the sources write it, which is what compilers call it; empty for a value that
/// has none.
template <auto Value>
[[nodiscard]] constexpr std::string_view written() {
  constexpr std::string_view before = "Value = ";
  const std::string_view all = __PRETTY_FUNCTION__;
  const std::size_t begin = all.find(before) + before.size();
  const std::string_view value = all.substr(begin, all.find_first_of(";]", begin) - begin);
  return value.front() == '(' ? std::string_view() : value.substr(value.rfind(':') + 1);
}

template <class Enum, std::size_t So_far = 0>
[[nodiscard]] consteval std::size_t count_of_enumerators() {
  if constexpr (written<static_cast<Enum>(So_far)>().empty()) {
    return So_far;
  } else {
    return count_of_enumerators<Enum, So_far + 1>();
  }
}

template <class Enum>
inline constexpr auto all_enumerators = []<std::size_t... I>(std::index_sequence<I...> /*all*/) {
  return std::array{Named<Enum>(static_cast<Enum>(I), written<static_cast<Enum>(I)>())...};
}
(std::make_index_sequence<count_of_enumerators<Enum>()>());

/// The enumerators from 0 on with their names; the argument only selects the enum. An enum whose
/// names are not those of its enumerators has a function of its own beside it:
///   std::span<const Named<Side>> enumerators(Side) noexcept;
template <class Enum>
requires std::is_enum_v<Enum>
[[nodiscard]] constexpr std::span<const Named<Enum>> enumerators(Enum /*any*/) noexcept {
  return all_enumerators<Enum>;
}

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
