// SPDX-License-Identifier: MIT
#pragma once

// A result with a table of its fields as a JSON object.

#include <stillpoint/core/field.hpp>
#include <stillpoint/core/names.hpp>
#include "json/parts.hpp"

#include <nlohmann/json.hpp>

#include <functional>
#include <optional>
#include <string>
#include <string_view>
#include <type_traits>
#include <variant>
#include <vector>

namespace stillpoint::report {

template <class Value>
inline constexpr bool is_optional = false;
template <class Value>
inline constexpr bool is_optional<std::optional<Value>> = true;
template <class Value>
inline constexpr bool is_vector = false;
template <class Value>
inline constexpr bool is_vector<std::vector<Value>> = true;
template <class Value>
inline constexpr bool is_variant = false;
template <class... Values>
inline constexpr bool is_variant<std::variant<Values...>> = true;

/// An integer where the field has counts.
[[nodiscard]] nlohmann::ordered_json number_json(double value, const Measure& measure);
/// Those of a report with physical input; else null.
using Scales = const design::Scales*;
[[nodiscard]] inline Scales scales_of(const Physical& physical) {
  return physical ? &physical->scales : nullptr;
}
/// The value of a field, and in SI units if the field says so: a number, or the ends of an
/// interval. Out of line, as every field of every report comes here.
void put(nlohmann::ordered_json& object, std::string_view name, nlohmann::ordered_json value,
         const Measure& measure, Scales scales);
/// "delta_m" beside "delta".
[[nodiscard]] std::string si_name(std::string_view name, const Measure& measure);

template <class Result>
[[nodiscard]] nlohmann::ordered_json object_json(const Result& result, Scales scales = nullptr);

/// The value of a field.
template <class Value>
[[nodiscard]] nlohmann::ordered_json value_json(const Value& value, const Measure& measure = {},
                                                Scales scales = nullptr) {
  if constexpr (is_optional<Value>) {
    return value ? value_json(*value, measure, scales) : nlohmann::ordered_json(nullptr);
  } else if constexpr (std::is_same_v<Value, double>) {
    return number_json(value, measure);
  } else if constexpr (HasNames<Value>) {
    return name(value);
  } else if constexpr (HasFields<Value>) {
    return object_json(value, scales);
  } else if constexpr (requires { own_json(value); }) {
    return own_json(value);
  } else if constexpr (is_variant<Value>) {
    return std::visit([&](const auto& one) { return value_json(one, measure, scales); }, value);
  } else if constexpr (requires { value.low, value.high; }) {
    return interval_json(value);
  } else if constexpr (is_vector<Value>) {
    return list_json(value, [&](const auto& item) { return value_json(item, measure, scales); });
  } else {
    return value;
  }
}

template <class Fields, class Result>
void add_fields(nlohmann::ordered_json& json, const Fields& all, const Result& result,
                Scales scales = nullptr) {
  for_each_field(all, [&](const auto& field) {
    put(json, field.name, value_json(std::invoke(field.get, result), field.measure, scales),
        field.measure, scales);
  });
}

/// By its table, in its order.
template <class Result>
nlohmann::ordered_json object_json(const Result& result, Scales scales) {
  auto json = nlohmann::ordered_json::object();
  add_fields(json, fields<Result>, result, scales);
  return json;
}

}  // namespace stillpoint::report
