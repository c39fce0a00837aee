// SPDX-License-Identifier: MIT
#pragma once

// A result with a table of its fields as a JSON object. The headers that this one brings are not
// listed again in this folder.

#include "units.hpp"

#include <stillpoint/report/report.hpp>

#include <numbers>

namespace stillpoint {

/// The period of the spring alone, in tau.
[[nodiscard]] inline double turn(double p) {
  return 2 * std::numbers::pi / p;
}
inline constexpr Measure any_number{Numbers::all};
inline constexpr Measure at_least_one{Numbers::from_one};
constexpr Measure one_of(std::span<const std::string_view> texts) {
  return {.texts = texts};
}
/// With the value in SI units beside it, or in its place.
constexpr Measure with_si(Dimension dimension, std::string_view name = {}) {
  return {{}, dimension, name, {}, InSi::beside};
}
constexpr Measure si_alone(Dimension dimension, Numbers numbers = {}) {
  return {numbers, dimension, {}, {}, InSi::alone};
}
constexpr Measure si_always(Dimension dimension, Numbers numbers = {}) {
  return {numbers, dimension, {}, {}, InSi::always};
}
/// Only in the reports of motions that have another value.
constexpr Measure unless(double usual) {
  return {.usual = usual};
}
/// Those of an oscillator that the paper's does not have.
inline constexpr std::tuple beyond_the_paper{
    Field{"damping", &Oscillator::zeta, "the share of critical damping", unless(0)},
    Field{"breakaway", &Oscillator::breakaway, "the friction that holds a mass at rest, over f",
          unless(1)}};
inline constexpr Measure in_metres = with_si(Dimension::length);

/// A table of part of a result: each field is taken from what `whole` gives; empty without it.
constexpr auto fields_in(auto whole, const auto& part) {
  return std::apply(
      [whole](const auto&... field) {
        return std::tuple{Field{field.name, in(whole, field.get), field.words, field.measure}...};
      },
      part);
}

/// What `get` gives, where `holds`; else empty.
constexpr auto only_if(auto holds, auto get) {
  return in([holds](const auto& now) { return std::invoke(holds, now) ? &now : nullptr; }, get);
}
/// What `get` gives of each item.
[[nodiscard]] auto mapped(const auto& list, const auto& get) {
  std::vector<std::remove_cvref_t<decltype(std::invoke(get, list.front()))>> all;
  all.reserve(list.size());
  for (const auto& item : list) {
    all.push_back(std::invoke(get, item));
  }
  return all;
}

}  // namespace stillpoint

namespace stillpoint::report {

using stillpoint::in;
using Name = std::optional<std::string>;

/// A value that no table prints, with its schema.
template <nlohmann::ordered_json (*make_schema)()>
struct Printed {
  static constexpr auto schema = make_schema;
  nlohmann::ordered_json json;
};

/// An integer where the field has counts, if a double holds it exactly.
[[nodiscard]] nlohmann::ordered_json number_json(double value, Numbers numbers);
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
[[nodiscard]] nlohmann::ordered_json value_json(const Value& value, Numbers numbers = {},
                                                Scales scales = nullptr) {
  if constexpr (is_optional<Value> || is_reference<Value>) {
    return value ? value_json(*value, numbers, scales) : nlohmann::ordered_json(nullptr);
  } else if constexpr (std::is_same_v<Value, double>) {
    return number_json(value, numbers);
  } else if constexpr (HasNames<Value>) {
    return name(value);
  } else if constexpr (HasFields<Value>) {
    return object_json(value, scales);
  } else if constexpr (requires { value.json; }) {
    return value.json;
  } else if constexpr (requires { value.low, value.high; }) {
    return nlohmann::ordered_json::array({value_json(value.low), value_json(value.high)});
  } else if constexpr (std::is_arithmetic_v<Value> ||
                       std::is_convertible_v<Value, std::string_view>) {
    return value;
  } else {
    auto list = nlohmann::ordered_json::array();
    for (const auto& item : value) {
      list.push_back(value_json(item, numbers, scales));
    }
    return list;
  }
}

/// The table is an argument of the template, so that no words of it, which schemas need, are in
/// what prints a report.
template <const auto& all, std::size_t i, class Result>
void add_field(nlohmann::ordered_json& json, const Result& result, Scales scales) {
  constexpr auto get = std::get<i>(all).get;
  constexpr std::string_view name = std::get<i>(all).name;
  static constexpr Measure measure = std::get<i>(all).measure;
  put(json, name, value_json(std::invoke(get, result), measure.numbers, scales), measure, scales);
}

/// By its table, in its order.
template <const auto& all, class Result>
[[nodiscard]] nlohmann::ordered_json object_by(const Result& result, Scales scales = nullptr) {
  auto json = nlohmann::ordered_json::object();
  [&]<std::size_t... i>(std::index_sequence<i...>) {
    (add_field<all, i>(json, result, scales), ...);
  }
  (std::make_index_sequence<std::tuple_size_v<std::remove_cvref_t<decltype(all)>>>());
  return json;
}

template <class Result>
nlohmann::ordered_json object_json(const Result& result, Scales scales) {
  return object_by<fields<Result>>(result, scales);
}

}  // namespace stillpoint::report
