// SPDX-License-Identifier: MIT
#pragma once

// The JSON Schema of what fields.hpp prints, from the same tables: of a value by its type.

#include "json/fields.hpp"

namespace stillpoint::report {

inline constexpr std::string_view dimensionless_numbers =
    "Numbers are dimensionless unless a name ends in a unit";

[[nodiscard]] nlohmann::ordered_json number_schema(bool whole, Numbers numbers);
[[nodiscard]] nlohmann::ordered_json text_schema(std::span<const std::string_view> texts,
                                                 bool may_be_empty);
/// With at least so many items.
[[nodiscard]] nlohmann::ordered_json list_schema(nlohmann::ordered_json item, int least);
/// Null as well.
[[nodiscard]] nlohmann::ordered_json or_null_schema(nlohmann::ordered_json schema);
/// Of a field, and of its value in SI units if the field says so.
void add_property(nlohmann::ordered_json& properties, std::string_view name, std::string_view words,
                  nlohmann::ordered_json schema, const Measure& measure);
/// An object in which no field of `properties` is missing, unless it has a default.
[[nodiscard]] nlohmann::ordered_json object_schema(nlohmann::ordered_json properties);
/// For a result that a report has in many places, the name of its schema among the $defs.
template <class Result>
inline constexpr std::string_view shared_name{};
/// The whole of a report: "stillpoint/design-report/2" of what "design --json" prints.
[[nodiscard]] nlohmann::ordered_json document_schema(std::string_view name,
                                                     std::string_view command,
                                                     std::string_view description,
                                                     nlohmann::ordered_json properties,
                                                     nlohmann::ordered_json definitions);

/// These add to the $defs.
template <class Result>
[[nodiscard]] nlohmann::ordered_json schema_of(nlohmann::ordered_json& definitions);

template <class Value>
[[nodiscard]] nlohmann::ordered_json value_schema(const Measure& measure,
                                                  nlohmann::ordered_json& definitions) {
  if constexpr (requires { Value::schema; }) {
    return Value::schema();
  } else if constexpr (is_optional<Value>) {
    return or_null_schema(value_schema<typename Value::value_type>(measure, definitions));
  } else if constexpr (is_reference<Value>) {
    return or_null_schema(
        value_schema<std::remove_cvref_t<std::remove_pointer_t<Value>>>(measure, definitions));
  } else if constexpr (std::is_same_v<Value, bool>) {
    return {{"type", "boolean"}};
  } else if constexpr (std::is_arithmetic_v<Value>) {
    return number_schema(std::is_integral_v<Value>, measure.numbers);
  } else if constexpr (HasNames<Value>) {
    const auto all = names<Value>();
    return text_schema(all, false);
  } else if constexpr (std::is_convertible_v<Value, std::string_view>) {
    return text_schema(measure.texts, measure.numbers == Numbers::all);
  } else if constexpr (HasFields<Value>) {
    return schema_of<Value>(definitions);
  } else if constexpr (requires(const Value& value) { value.low, value.high; }) {
    return list_schema(value_schema<decltype(Value::high)>(measure, definitions), 2);
  } else if constexpr (requires { typename Value::value_type; }) {
    const bool filled = measure.numbers == Numbers::from_one;
    Measure of_item = measure;
    of_item.numbers = filled ? Numbers() : measure.numbers;
    return list_schema(value_schema<typename Value::value_type>(of_item, definitions),
                       filled ? 1 : 0);
  } else {
    static_assert(std::is_same_v<Value, nlohmann::ordered_json>, "a value without a schema");
    return {};
  }
}

/// The properties of the fields of such a result.
template <class Result, class Fields>
[[nodiscard]] nlohmann::ordered_json properties_of(const Fields& all,
                                                   nlohmann::ordered_json& definitions) {
  auto properties = nlohmann::ordered_json::object();
  for_each_field(all, [&]<class Get>(const Field<Get>& field) {
    using Value = std::remove_cvref_t<std::invoke_result_t<Get, const Result&>>;
    add_property(properties, field.name, field.words,
                 value_schema<Value>(field.measure, definitions), field.measure);
  });
  return properties;
}

template <class Result>
nlohmann::ordered_json schema_of(nlohmann::ordered_json& definitions) {
  constexpr std::string_view name = shared_name<Result>;
  auto schema = object_schema(properties_of<Result>(fields<Result>, definitions));
  if (name.empty()) {
    return schema;
  }
  definitions[std::string(name)] = std::move(schema);
  return {{"$ref", "#/$defs/" + std::string(name)}};
}

/// Of a report by its table.
template <class Report, class Fields>
[[nodiscard]] nlohmann::ordered_json report_schema(
    const Fields& all, std::string_view name, std::string_view command,
    std::string_view description = dimensionless_numbers) {
  nlohmann::ordered_json definitions;
  auto properties = properties_of<Report>(all, definitions);
  return document_schema(name, command, description, std::move(properties), std::move(definitions));
}

}  // namespace stillpoint::report
