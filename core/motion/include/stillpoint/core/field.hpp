// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <functional>
#include <optional>
#include <span>
#include <string_view>
#include <tuple>
#include <type_traits>

namespace stillpoint {

/// What a value measures, which decides the units that it may have.
enum class Dimension : std::uint8_t {
  none,
  length,
  velocity,
  time,
  frequency,
  mass,
  stiffness,
  acceleration,
  gravities,  ///< an acceleration as a multiple of g
  force,      ///< these three per weight, weight times length, and mass times velocity
  energy,
  impulse,
  share,  ///< of a whole; it may be in per cent
};

/// What the name of a value in SI units ends in; empty of what reports have in one unit alone.
[[nodiscard]] constexpr std::string_view si_suffix(Dimension dimension) {
  switch (dimension) {
    case Dimension::length:
      return "_m";
    case Dimension::time:
      return "_s";
    case Dimension::velocity:
      return "_m_per_s";
    case Dimension::force:
      return "_n";
    case Dimension::energy:
      return "_j";
    case Dimension::impulse:
      return "_n_s";
    default:
      return "";
  }
}

/// Which numbers a field may hold.
enum class Numbers : std::uint8_t {
  from_zero,  ///< no negative ones
  all,        ///< of a text: an empty one as well
  counts,     ///< 0, 1, 2 and so on, though a double may hold them
  from_one,   ///< 1, 2 and so on; of a list: how many there are
};

/// Where a report has a value in SI units.
enum class InSi : std::uint8_t {
  apart,   ///< under its physical name, if it has one, among others in `physical`
  beside,  ///< behind the value, under that name, or else its own with the suffix
  alone,   ///< in place of the value
  always,  ///< the same in a report that has no other
};

/// What the value of a field is. `physical` is its name in SI units.
struct Measure {
  Numbers numbers{};
  Dimension dimension{};
  std::string_view physical{};
  std::span<const std::string_view> texts{};  ///< of a text: all that it may be; empty: any
  InSi si{};
  std::optional<double> usual{};  ///< which a report leaves out
};

inline constexpr Measure counted{Numbers::counts};
/// With its value in SI units under that name among others.
constexpr Measure si_apart(Dimension dimension, std::string_view physical, Numbers numbers = {}) {
  return {numbers, dimension, physical};
}

/// A figure of a result, stated once: its name in reports, the member that holds it, or a function
/// that gives it, what it means, and its measure.
template <class Get>
struct Field {
  std::string_view name;
  Get get;
  std::string_view words{};
  Measure measure{};
};
template <class Get>
Field(std::string_view, Get, std::string_view = {}, Measure = {}) -> Field<Get>;

template <class Value>
inline constexpr bool is_optional = false;
template <class Value>
inline constexpr bool is_optional<std::optional<Value>> = true;
/// Optional, by a pointer into the answer.
template <class Value>
inline constexpr bool is_reference =
    std::is_pointer_v<Value>&& std::is_class_v<std::remove_pointer_t<Value>>;

/// A member of a member, and so on: in(&Simulation::response, &Response::jump). Behind an optional
/// or a pointer it is optional as well, and empty without that.
template <class First, class... More>
requires(!std::is_convertible_v<First, std::string_view>) constexpr auto in(First first,
                                                                            More... more) {
  if constexpr (sizeof...(More) == 0) {
    return first;
  } else {
    return [first, rest = in(more...)](const auto& whole) -> decltype(auto) {
      const auto& part = std::invoke(first, whole);
      using Part = std::remove_cvref_t<decltype(part)>;
      if constexpr (is_optional<Part> || is_reference<Part>) {
        using Value = std::remove_cvref_t<decltype(std::invoke(rest, *part))>;
        using Shown = std::conditional_t<is_optional<Value> || is_reference<Value>, Value,
                                         std::optional<Value>>;
        return part ? Shown(std::invoke(rest, *part)) : Shown();
      } else {
        return std::invoke(rest, part);
      }
    };
  }
}

template <class Result>
constexpr auto own_fields() {
  if constexpr (requires { Result::field_table; }) {
    return Result::field_table;
  } else {
    return nullptr;
  }
}

/// The figures of a result, a tuple of Field in the order of its report. What a report, its schema,
/// a sweep and the docs say of the result follows from it. What only reports have states it itself,
/// in `field_table`.
template <class Result>
inline constexpr auto fields = own_fields<Result>();

template <class Result>
concept HasFields = !std::is_null_pointer_v<std::remove_const_t<decltype(fields<Result>)>>;

/// Calls `use` with each Field of a tuple in turn.
template <class Fields, class Use>
constexpr void for_each_field(const Fields& all, const Use& use) {
  std::apply([&use](const auto&... field) { (use(field), ...); }, all);
}

}  // namespace stillpoint
