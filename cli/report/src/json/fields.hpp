// SPDX-License-Identifier: MIT
#pragma once

// A result with a table of its fields as a JSON object.

#include <stillpoint/core/field.hpp>
#include <stillpoint/core/names.hpp>
#include "json/parts.hpp"

#include <nlohmann/json.hpp>

#include <functional>
#include <optional>
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
/// Out of line, as every field of every report comes here.
void put(nlohmann::ordered_json& object, std::string_view name, nlohmann::ordered_json value);

template <class Result>
[[nodiscard]] nlohmann::ordered_json object_json(const Result& result);

/// The value of a field.
template <class Value>
[[nodiscard]] nlohmann::ordered_json value_json(const Value& value, const Measure& measure = {}) {
  if constexpr (is_optional<Value>) {
    return value ? value_json(*value, measure) : nlohmann::ordered_json(nullptr);
  } else if constexpr (std::is_same_v<Value, double>) {
    return number_json(value, measure);
  } else if constexpr (HasNames<Value>) {
    return name(value);
  } else if constexpr (HasFields<Value>) {
    return object_json(value);
  } else if constexpr (requires { own_json(value); }) {
    return own_json(value);
  } else if constexpr (is_variant<Value>) {
    return std::visit([&](const auto& one) { return value_json(one, measure); }, value);
  } else if constexpr (requires { value.low, value.high; }) {
    return interval_json(value);
  } else if constexpr (is_vector<Value>) {
    return list_json(value, [&](const auto& item) { return value_json(item, measure); });
  } else {
    return value;
  }
}

template <class Fields, class Result>
void add_fields(nlohmann::ordered_json& json, const Fields& all, const Result& result) {
  for_each_field(all, [&](const auto& field) {
    put(json, field.name, value_json(std::invoke(field.get, result), field.measure));
  });
}

/// By its table, in its order.
template <class Result>
nlohmann::ordered_json object_json(const Result& result) {
  auto json = nlohmann::ordered_json::object();
  add_fields(json, fields<Result>, result);
  return json;
}

}  // namespace stillpoint::report
