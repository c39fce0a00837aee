// SPDX-License-Identifier: MIT
#include "json/fields.hpp"

#include <stillpoint/records/text.hpp>

#include <fmt/format.h>

#include <algorithm>
#include <cassert>
#include <cmath>

namespace stillpoint::report {

using nlohmann::ordered_json;

namespace {

/// Any other number would be written as null.
[[maybe_unused]] bool is_finite(const ordered_json& json) {
  return json.is_structured() ? std::ranges::all_of(json, is_finite)
                              : !json.is_number_float() || std::isfinite(json.get<double>());
}

/// An object is one of such values. Null of what does not exist or is beyond a double, without
/// scales, and of a force whose mass is not known.
ordered_json in_si(const ordered_json& value, Dimension dimension, Scales scales) {
  if (scales == nullptr || value.is_null()) {
    return nullptr;
  }
  if (value.is_object()) {
    return value;
  }
  if (value.is_array()) {
    return ordered_json::array(
        {in_si(value[0], dimension, scales), in_si(value[1], dimension, scales)});
  }
  const auto scaled = scales->in_si(dimension, value.get<double>());
  return scaled && std::isfinite(*scaled) ? ordered_json(*scaled) : nullptr;
}

}  // namespace

ordered_json number_json(double value, Numbers numbers) {
  constexpr double exact = 9007199254740992;  // 2^53
  const bool counts = numbers == Numbers::counts || numbers == Numbers::from_one;
  return counts && value <= exact ? ordered_json(static_cast<std::int64_t>(value))
                                  : ordered_json(value);
}

std::string si_name(std::string_view name, const Measure& measure) {
  return measure.physical.empty() ? std::string(name) + std::string(si_suffix(measure.dimension))
                                  : std::string(measure.physical);
}

void put(ordered_json& object, std::string_view name, ordered_json value, const Measure& measure,
         Scales scales) {
  if (measure.usual && (value.is_null() || value == *measure.usual)) {
    return;
  }
  const bool apart = measure.si == InSi::apart;
  ordered_json twin = apart ? nullptr : in_si(value, measure.dimension, scales);
  const bool beside = measure.si == InSi::beside;
  object[std::string(name)] = apart || beside ? std::move(value) : twin;
  if (beside) {
    object[si_name(name, measure)] = std::move(twin);
  }
}

std::string json_text(const ordered_json& json) {
  constexpr int spaces = 2;
  assert(is_finite(json));
  // A terminal may show it: controls beyond ASCII are escaped too.
  const auto escaped = [](unsigned code) {
    return code == '\n' ? "\n" : fmt::format("\\u{:04x}", code);
  };
  return records::with_controls_as(escaped, json.dump(spaces)) + "\n";
}

}  // namespace stillpoint::report
