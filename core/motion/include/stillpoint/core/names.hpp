// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <array>
#include <cassert>
#include <cstddef>
#include <optional>
#include <span>
#include <string_view>
#include <utility>

namespace stillpoint {

template <class Enum>
using Named = std::pair<Enum, std::string_view>;

/// The names of an enum's enumerators, one row each, for both directions:
///   constexpr Names sides(std::to_array<Named<Side>>({{Side::left, "left"}, ...}));
template <class Enum, std::size_t size>
class Names {
 public:
  explicit constexpr Names(std::array<Named<Enum>, size> rows) : rows_(std::move(rows)) {
    std::ranges::transform(rows_, names_.begin(), &Named<Enum>::second);
  }

  [[nodiscard]] constexpr std::string_view name(Enum value) const noexcept {
    const auto row = std::ranges::find(rows_, value, &Named<Enum>::first);
    assert(row != rows_.end() && "an enumerator without a name");
    return row->second;
  }

  /// Empty for a name that is in no row.
  [[nodiscard]] constexpr std::optional<Enum> parse(std::string_view name) const noexcept {
    const auto row = std::ranges::find(rows_, name, &Named<Enum>::second);
    return row != rows_.end() ? std::optional(row->first) : std::nullopt;
  }

  /// All of them, in the order of the rows.
  [[nodiscard]] constexpr std::span<const std::string_view> all() const noexcept { return names_; }

 private:
  std::array<Named<Enum>, size> rows_;
  std::array<std::string_view, size> names_{};
};

}  // namespace stillpoint
