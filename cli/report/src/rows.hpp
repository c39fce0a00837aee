// SPDX-License-Identifier: MIT
#pragma once

// The figures of a result as rows for people, by the table of its fields.

#include "format.hpp"
#include "sections.hpp"

#include <stillpoint/core/field.hpp>
#include <stillpoint/core/names.hpp>
#include <stillpoint/report/digits.hpp>

#include <algorithm>
#include <array>
#include <functional>
#include <optional>
#include <string>
#include <string_view>
#include <type_traits>

namespace stillpoint::report {

/// A value as a row shows it; empty for what there is none of. A row has no room for lists and
/// objects.
[[nodiscard]] inline std::string cell(const Physical& physical, double value,
                                      const Measure& measure) {
  return value == 0 && measure.numbers != Numbers::all ? ""
         : measure.numbers == Numbers::counts || measure.numbers == Numbers::from_one
             ? whole(value)
             : figure_shown(physical, measure.dimension, value);
}
[[nodiscard]] inline std::string cell(const Physical& /*physical*/, bool value,
                                      const Measure& /*measure*/) {
  return value ? "yes" : "";
}
template <HasNames Value>
[[nodiscard]] std::string cell(const Physical& /*physical*/, Value value,
                               const Measure& /*measure*/) {
  return in_words(name(value));
}
template <class Value>
requires requires(const Physical& physical, const Value& value, const Measure& measure) {
  cell(physical, value, measure);
}
[[nodiscard]] std::string cell(const Physical& physical, const std::optional<Value>& value,
                               const Measure& measure) {
  return value ? cell(physical, *value, measure) : std::string();
}

/// Of each field that has a value.
template <class Fields, class Result>
void add_rows(Section& section, const Fields& all, const Result& result, const Physical& physical) {
  for_each_field(all, [&](const auto& field) {
    const auto& value = std::invoke(field.get, result);
    if constexpr (requires { cell(physical, value, field.measure); }) {
      if (std::string text = cell(physical, value, field.measure); !text.empty()) {
        section.row(in_words(field.name), std::move(text));
      }
    }
  });
}
template <class Result>
void add_rows(Section& section, const Result& result, const Physical& physical) {
  add_rows(section, fields<Result>, result, physical);
}

/// "N/m" of secant_stiffness_n_per_m, and how much of the name that takes.
struct SiUnit {
  std::string_view suffix;
  std::string_view unit;
};
[[nodiscard]] inline SiUnit si_unit_of(std::string_view name) {
  // Those that end in others first.
  static constexpr std::array units{SiUnit{"_n_per_m", "N/m"}, SiUnit{"_n_s", "N s"},
                                    SiUnit{"_n", "N"}, SiUnit{"_j", "J"}, SiUnit{"_m", "m"}};
  const auto* const found =
      std::ranges::find_if(units, [&](const SiUnit& now) { return name.ends_with(now.suffix); });
  return found == units.end() ? SiUnit{} : *found;
}

/// Of fields whose names end in their SI units.
template <class Fields, class Result>
void add_si_rows(Section& section, const Fields& all, const Result& result) {
  for_each_field(all, [&](const auto& field) {
    const auto [suffix, unit] = si_unit_of(field.name);
    const auto value = std::invoke(field.get, result);
    if constexpr (std::is_same_v<std::remove_cv_t<decltype(value)>, std::optional<double>>) {
      if (value && !unit.empty()) {
        section.row(in_words(field.name.substr(0, field.name.size() - suffix.size())),
                    with_unit(*value, unit));
      }
    }
  });
}

}  // namespace stillpoint::report
